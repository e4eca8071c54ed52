#include "output_file.h"

#include "deferred_signals.h"

#include <candela/error.h>
#include <candela/whole_file.h>

#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <span>
#include <system_error>

using candela::Error;
using candela::ErrorKind;

namespace {

[[noreturn]] void fail(const std::filesystem::path& path, const std::string& text) {
    throw Error(ErrorKind::environment, path.string(), text);
}

[[noreturn]] void failWithErrno(const std::filesystem::path& path, const std::string& doing) {
    fail(path, doing + ": " + std::strerror(errno));
}

std::filesystem::path folderOf(const std::filesystem::path& path) {
    return path.has_parent_path() ? path.parent_path() : std::filesystem::path(".");
}

/// A device, a pipe and the like: there is nothing to put in its place.
bool isSpecial(const std::filesystem::path& path) {
    std::error_code ignored;
    const std::filesystem::file_status status = std::filesystem::status(path, ignored);
    return std::filesystem::exists(status) && !std::filesystem::is_regular_file(status) &&
           !std::filesystem::is_directory(status);
}

}  // namespace

void checkWritable(const std::filesystem::path& path) {
    std::error_code ignored;
    const std::filesystem::path folder = folderOf(path);
    if (!std::filesystem::exists(folder, ignored))
        fail(path, "the folder " + folder.string() + " does not exist");
    if (!std::filesystem::is_directory(folder, ignored)) fail(path, folder.string() + " is not a folder");
    if (std::filesystem::is_directory(path, ignored)) fail(path, "is a folder");
    if (isSpecial(path)) return;
    if (access(folder.c_str(), W_OK | X_OK) != 0)
        failWithErrno(path, "the folder " + folder.string() + " cannot be written to");
}

void writeText(const std::filesystem::path& path, const std::string& text) {
    const DeferredSignals deferred;
    candela::writeWholeFile(path, std::as_bytes(std::span(text)));
}
