#include "messages.h"

#include <opensubdiv/far/error.h>

#include <mutex>

namespace candela_opensubdiv {
namespace {

namespace Far = OpenSubdiv::Far;

thread_local MessageCatcher* current = nullptr;

void takeError(Far::ErrorType, const char* message) {
    if (current != nullptr) current->take(message);
}

void dropWarning(const char*) {}

}  // namespace

MessageCatcher::MessageCatcher() : outer_(current) {
    static std::once_flag set;
    std::call_once(set, [] {
        Far::SetErrorCallback(takeError);
        Far::SetWarningCallback(dropWarning);
    });
    current = this;
}

MessageCatcher::~MessageCatcher() {
    current = outer_;
}

void MessageCatcher::take(const char* error) {
    if (error_.empty()) error_ = error;
}

}  // namespace candela_opensubdiv
