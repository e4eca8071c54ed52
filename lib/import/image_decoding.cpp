#include "import/image_decoding.h"

#include "import/abi_import.h"
#include "import/plugin_abi.h"
#include "import/text.h"

#include <candela/error.h>

#include <new>

namespace candela {

namespace {

/// One call of a decoder.
class Decoding {
  public:
    Decoding(const candela_image_bytes& file, std::size_t index) : file_(file), index_(index) {
        interface_.struct_size = sizeof interface_;
        interface_.self = this;
        interface_.fail = fail;
        interface_.set_result = setResult;
    }

    DecodedImage run(const candela_plugin& plugin) {
        const std::string by = joined("the plugin '", plugin.name, "' ");
        candela_status status = CANDELA_FAILED;
        try {
            status = plugin.image_decoder->decode(&interface_, file_.bytes, file_.size);
        } catch (...) {
            return {std::nullopt, by + "threw an exception, which the plugin interface forbids"};
        }
        if (isOutOfMemory_) throw std::bad_alloc();
        if (!result_.reason.empty()) return {std::nullopt, result_.reason};
        if (status == CANDELA_OK && result_.image) return result_;
        return {std::nullopt, by + "failed and gave no reason"};
    }

  private:
    static Decoding& from(void* self) { return *static_cast<Decoding*>(self); }

    template <class Action>
    bool guarded(Action action) noexcept {
        try {
            action();
            return true;
        } catch (const Error& error) {
            result_.reason = error.what();
        } catch (const std::bad_alloc&) {
            isOutOfMemory_ = true;
        }
        return false;
    }
    static void fail(void* self, const char* reason) {
        from(self).guarded([&] {
            from(self).result_.reason = reason && *reason ? oneLine(reason) : "the plugin gives no reason";
        });
    }
    static candela_status setResult(void* self, const candela_image* image) {
        Decoding& call = from(self);
        const bool taken = call.guarded([&] {
            const AbiReader element("image", call.index_, call.file_.name);
            if (!image) element.refuse("the decoded image is NULL");
            const auto copy = copyOf(image);
            if (!copy) element.refuse("struct_size of the decoded image " + sizeFault(image));
            call.result_.image = imageFrom(*copy, element);
        });
        return taken ? CANDELA_OK : CANDELA_FAILED;
    }

    const candela_image_bytes& file_;
    std::size_t index_;
    candela_decoding interface_{};
    DecodedImage result_;
    bool isOutOfMemory_ = false;
};

}  // namespace

DecodedImage decodeImage(std::span<const candela_plugin* const> decoders, const candela_image_bytes& file,
                         std::size_t index) {
    if (!file.bytes || file.size == 0) return {std::nullopt, "the file is empty"};
    for (const candela_plugin* plugin : decoders) {
        if (plugin->image_decoder->recognizes(file.bytes, file.size) != 0)
            return Decoding(file, index).run(*plugin);
    }
    return {std::nullopt, decoders.empty() ? "no plugin that decodes images is loaded"
                                           : "no plugin decodes a file that begins like this one"};
}

}  // namespace candela
