#include <candela/error.h>

#include <utility>

namespace candela {

Error::Error(ErrorKind kind, std::string path, const std::string& text)
    : std::runtime_error(path.empty() ? text : path + ": " + text), kind_(kind), path_(std::move(path)) {}

}  // namespace candela
