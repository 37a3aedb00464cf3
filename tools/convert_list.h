#pragma once

namespace tristim::tools {

/// Prints every model with its components, ranges and source, and the primaries, whites, curves and
/// adaptations that can be named with them; as text or as one JSON object.
void list_color_models(bool json);

}  // namespace tristim::tools
