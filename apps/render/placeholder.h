#pragma once

#include <filesystem>
#include <optional>

/// A file beside a picture that says that a process draws it: out.0007.png.lock. Of several processes that
/// draw the same list, each picture is drawn by one. The file is locked (fcntl) as long as the process lives;
/// one without a lock was left by a process that was killed, and is taken over. Where the file system has no
/// locks, one that is there counts as another process's.
class Placeholder {
  public:
    /// Takes the picture; none where another process has it. Throws `candela::Error` (environment) that names
    /// the file when it can not be created.
    static std::optional<Placeholder> take(const std::filesystem::path& picture);

    Placeholder(Placeholder&& other) noexcept;
    Placeholder& operator=(Placeholder&&) = delete;
    /// Deletes the file.
    ~Placeholder();

  private:
    Placeholder(std::filesystem::path path, int descriptor);

    std::filesystem::path path_;
    int descriptor_;  ///< -1 after a move.
};
