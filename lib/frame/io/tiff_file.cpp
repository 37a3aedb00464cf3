#include "lib/frame/io/tiff_file.h"

#include <algorithm>
#include <cstdarg>
#include <cstdio>
#include <memory>
#include <new>
#include <span>
#include <string_view>
#include <utility>

#include "tristim/core/error.h"

namespace tristim::detail {

TiffFile::TiffFile(OutputFile& file, bool large) : file_(&file) {
  const std::unique_ptr<TIFFOpenOptions, decltype(&TIFFOpenOptionsFree)> options(
      TIFFOpenOptionsAlloc(), TIFFOpenOptionsFree);
  if (!options) throw std::bad_alloc();
  TIFFOpenOptionsSetErrorHandlerExtR(options.get(), keep_message, this);
  TIFFOpenOptionsSetWarningHandlerExtR(options.get(), drop_message, this);
  // 'l': little endian on every machine
  tiff_ = TIFFClientOpenExt(file.path().c_str(), large ? "wl8" : "wl", this, read, write, seek,
                            close, size, nullptr, nullptr, options.get());
  check(tiff_ != nullptr ? 1 : 0);
}

TiffFile::~TiffFile() {
  file_ = nullptr;  // what libtiff still has is for a file that nobody will see
  if (tiff_ != nullptr) TIFFCleanup(tiff_);
}

void TiffFile::put_row(void* row) { check(TIFFWriteScanline(tiff_, row, next_row_++, 0)); }

void TiffFile::end() { check(TIFFWriteDirectory(tiff_)); }

void TiffFile::check(int result) {
  if (failure_) std::rethrow_exception(std::exchange(failure_, nullptr));
  if (result == 1) return;
  throw Error(ErrorKind::kSystem, file_->path(),
              std::string("cannot be written as TIFF: ") + message_.data());
}

// libtiff reads back only what it appends to, which a new file has not.
tmsize_t TiffFile::read(thandle_t /*self*/, void* /*bytes*/, tmsize_t /*size*/) { return 0; }

tmsize_t TiffFile::write(thandle_t handle, void* bytes, tmsize_t size) {
  auto* self = static_cast<TiffFile*>(handle);
  if (self->file_ == nullptr) return size;
  const std::span all(static_cast<const std::byte*>(bytes), static_cast<std::size_t>(size));
  try {  // nothing may be thrown through libtiff
    // directories begin at even places, so there may be a byte in between
    while (self->position_ > self->file_->size()) self->file_->write(std::string_view("\0", 1));
    const std::size_t over = std::min(all.size(), self->file_->size() - self->position_);
    if (over > 0) self->file_->write_at(self->position_, all.first(over));
    if (over < all.size()) self->file_->write(all.subspan(over));
    self->position_ += all.size();
    return size;
  } catch (...) {
    self->failure_ = std::current_exception();
    return 0;
  }
}

toff_t TiffFile::seek(thandle_t handle, toff_t offset, int whence) {
  auto* self = static_cast<TiffFile*>(handle);
  if (self->file_ == nullptr) return offset;
  const std::size_t from = whence == SEEK_CUR   ? self->position_
                           : whence == SEEK_END ? self->file_->size()
                                                : 0;
  self->position_ = from + static_cast<std::size_t>(offset);
  return self->position_;
}

toff_t TiffFile::size(thandle_t handle) {
  auto* self = static_cast<TiffFile*>(handle);
  return self->file_ == nullptr ? 0 : self->file_->size();
}

int TiffFile::close(thandle_t /*self*/) { return 0; }

int TiffFile::keep_message(TIFF* /*tiff*/, void* handle, const char* /*module*/, const char* format,
                           va_list arguments) {
  auto* self = static_cast<TiffFile*>(handle);
  std::vsnprintf(self->message_.data(), self->message_.size(), format, arguments);
  return 1;
}

int TiffFile::drop_message(TIFF* /*tiff*/, void* /*self*/, const char* /*module*/,
                           const char* /*format*/, va_list /*arguments*/) {
  return 1;
}

}  // namespace tristim::detail
