// What an import reads: files of the scene's folder, and images that plugins decode.

#include "base/thread_pool.h"
#include "import/host.h"
#include "import/image_decoding.h"
#include "import/text.h"

#include <candela/error.h>

#include <cstddef>
#include <cstdint>
#include <utility>

namespace candela {

candela_status ImportHost::addImageBytes(const candela_image_bytes* images, std::uint32_t count,
                                         std::int32_t* indices, const char** reasons) noexcept {
    const bool done = guarded("images", [&] {
        if (count > 0 && (!images || !indices || !reasons))
            throw Error(ErrorKind::badInput, uri_,
                        "add_image_bytes: its images, its indices or its reasons are NULL");
        const std::size_t first = scene_.images.size();
        std::vector<DecodedImage> decoded(count);
        pool_->run(count, [&](std::size_t i, unsigned) {
            decoded[i] = decodeImage(imageDecoders_, images[i], first + i);
        });
        for (std::uint32_t i = 0; i < count; ++i) {
            indices[i] = decoded[i].image ? static_cast<std::int32_t>(scene_.images.size()) : -1;
            reasons[i] = nullptr;
            if (decoded[i].image) {
                scene_.images.push_back(std::move(*decoded[i].image));
            } else {
                reasons[i] = reasons_.emplace_back(std::move(decoded[i].reason)).c_str();
            }
        }
    });
    return done ? CANDELA_OK : CANDELA_FAILED;
}

FileAccess& ImportHost::files(const char* path) {
    if (files_) return *files_;
    throw Error(ErrorKind::badInput, "",
                joined("file '", oneLine(path), "': a procedural scene has no folder to read files from"));
}

candela_status ImportHost::fileSize(const char* path, std::uint64_t* size) noexcept {
    const bool done = guarded("reading a file", [&] {
        if (!path || !size)
            throw Error(ErrorKind::badInput, uri_, "file_size: its path or its result is NULL");
        *size = files(path).size(path);
    });
    return done ? CANDELA_OK : CANDELA_FAILED;
}

candela_status ImportHost::readFilePart(const char* path, std::uint64_t offset, std::uint64_t size,
                                        void* into) noexcept {
    const bool done = guarded("reading a file", [&] {
        if (!path || (size > 0 && !into))
            throw Error(ErrorKind::badInput, uri_, "read_file_part: its path or its memory is NULL");
        files(path).readPart(path, offset, {static_cast<std::byte*>(into), size});
    });
    return done ? CANDELA_OK : CANDELA_FAILED;
}

candela_bytes ImportHost::fileBytes(const char* path) {
    const auto bytes = files(path).read(path);
    return {reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()};
}

candela_status ImportHost::readFile(const char* path, candela_bytes* out) noexcept {
    const bool done = guarded("reading a file", [&] {
        if (!path || !out)
            throw Error(ErrorKind::badInput, uri_, "read_file: its path or its result is NULL");
        *out = {};
        *out = fileBytes(path);
    });
    return done ? CANDELA_OK : CANDELA_FAILED;
}

candela_status ImportHost::readOptionalFile(const char* path, candela_bytes* out,
                                            const char** reason) noexcept {
    if (reason) *reason = "";
    bool read = false;
    guarded("reading a file", [&] {
        if (!path || !out || !reason)
            throw Error(ErrorKind::badInput, uri_,
                        "read_optional_file: its path, its result or its reason is NULL");
        *out = {};
        try {
            const std::string name = files_ ? files_->inAnyCase(path) : path;
            *out = fileBytes(name.c_str());
            read = true;
            if (name != path)
                notes_.add(NoteKind::information, joined("file '", oneLine(path), "'"),
                           "read, though its name differs in upper and lower case");
        } catch (const Error& error) {
            *reason = reasons_.emplace_back(error.what()).c_str();
        }
    });
    return read ? CANDELA_OK : CANDELA_FAILED;
}

}  // namespace candela
