#pragma once

#include <candela/export.h>

#include <cstddef>
#include <filesystem>
#include <span>

namespace candela {

/// Writes a file atomically: into a file without a name in the same folder, which gets its name once every
/// byte is on the disk. When the process is killed, or the disk or the limit of file sizes (`ulimit -f`) is
/// reached, nothing of it stays and an existing file is unchanged. (Where the file system has no files
/// without a name, a temporary file is used, which stays behind a killed process.)
///
/// A new file gets its permissions by the umask, a replaced one keeps its own. Symbolic links are followed.
/// What is not an ordinary file (a device, a pipe, an open descriptor such as /dev/stdout) can not be
/// replaced and is written in place.
///
/// Throws `Error` (environment) that names the file, and the folder if that is at fault.
CANDELA_API void writeWholeFile(const std::filesystem::path& path, std::span<const std::byte> bytes);

}  // namespace candela
