#include "panels/panel_work.h"

void addError(ViewModel& model, const char* text) {
    // A value that is dragged fails in every frame.
    if (!model.messages.empty() && model.messages.back().text == text) return;
    model.messages.push_back({Message::Kind::error, text});
}

std::uint64_t sceneNumber(const ViewModel& model) {
    static const Document* last = nullptr;
    static std::uint64_t number = 0;
    // The next document is made while the last one lives, so that their addresses differ.
    if (model.document.get() != last || number == 0) {
        last = model.document.get();
        ++number;
    }
    return number;
}
