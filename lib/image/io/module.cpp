#include "lib/image/io/module.h"

#include <dlfcn.h>

#include <string>

#include "tristim/core/error.h"

namespace tristim::detail {
namespace {

std::string module_path(const Module& module) {
  std::string file = std::string("tristim/") + module.file;
  Dl_info here = {};
  // of any function in this library
  if (dladdr(reinterpret_cast<const void*>(&load_function), &here) == 0 ||
      here.dli_fname == nullptr) {
    return file;
  }
  const std::string library = here.dli_fname;
  const std::size_t slash = library.rfind('/');
  return (slash == std::string::npos ? "./" : library.substr(0, slash + 1)) + file;
}

std::string last_error() {
  const char* text = dlerror();  // NOLINT(concurrency-mt-unsafe): local to the thread
  return text != nullptr ? text : "unknown reason";
}

}  // namespace

void* load_function(const Module& module) {
  const std::string path = module_path(module);
  void* const loaded =
      dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);  // never closed: it stays loaded
  if (loaded == nullptr) {
    throw Error(ErrorKind::kSystem, path, "cannot be loaded: " + last_error(), module.remedy);
  }
  void* const function = dlsym(loaded, module.function);
  if (function == nullptr) {
    throw Error(ErrorKind::kSystem, path, "is of another version of tristim: " + last_error(),
                "install tristim again");
  }
  return function;
}

}  // namespace tristim::detail
