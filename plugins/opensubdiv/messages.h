#pragma once

#include <string>

namespace candela_opensubdiv {

/// Takes what OpenSubdiv would print. Its callbacks belong to the whole process, so they are set once and
/// hand each message to the catcher of the thread that it comes from; without one it is dropped.
class MessageCatcher {
  public:
    MessageCatcher();
    ~MessageCatcher();
    MessageCatcher(const MessageCatcher&) = delete;
    MessageCatcher& operator=(const MessageCatcher&) = delete;

    /// The first error since the catcher was made; empty where there was none. Warnings are dropped: what
    /// they tell of a cage the plugin checks itself.
    const std::string& error() const { return error_; }

    void take(const char* error);

  private:
    std::string error_;
    MessageCatcher* outer_;
};

}  // namespace candela_opensubdiv
