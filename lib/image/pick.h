#pragma once

#include <memory>
#include <vector>

#include "tristim/image/picture.h"

namespace tristim::detail {

/// The picture of these columns of the source, in this order; indices may repeat and be left out.
std::unique_ptr<RowSource> pick_columns(std::unique_ptr<RowSource> source,
                                        std::vector<int> columns);

/// The picture of these rows of the source, which never go back; they may repeat and be left out.
std::unique_ptr<RowSource> pick_rows(std::unique_ptr<RowSource> source, std::vector<int> rows);

/// The means of `count` groups of rows, alike in size but for one row.
std::unique_ptr<RowSource> average_rows(std::unique_ptr<RowSource> source, int count);

}  // namespace tristim::detail
