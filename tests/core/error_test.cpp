#include "tristim/core/error.h"

#include <gtest/gtest.h>

#include <cerrno>

namespace tristim {
namespace {

TEST(ErrorText, JoinsThingWrongAndRemedy) {
  const Error error(ErrorKind::kMisuse, "--device", "unknown device 'x'", "use one of: a, b");
  EXPECT_STREQ(error.what(), "--device: unknown device 'x'; use one of: a, b");
  EXPECT_EQ(error.kind(), ErrorKind::kMisuse);
  EXPECT_STREQ(Error(ErrorKind::kSystem, "a.exr", "no such file").what(), "a.exr: no such file");
}

TEST(ErrorText, IsOnePrintableLine) {
  const Error error(ErrorKind::kContent, "a\nb\x1b.png", "bad\tpicture\x7f", "mend\r\nit");
  EXPECT_STREQ(error.what(), "a?b?.png: bad?picture?; mend??it");
  // The bytes of UTF-8 are no control characters.
  EXPECT_STREQ(Error(ErrorKind::kContent, "b\xc3\xa4r.png", "bad").what(), "b\xc3\xa4r.png: bad");
}

TEST(SystemMessage, StartsWithASmallLetter) {
  EXPECT_EQ(system_message(ENOENT), "no such file or directory");
}

}  // namespace
}  // namespace tristim
