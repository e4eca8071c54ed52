#include "texture_info.h"

#include <algorithm>

#include "file_names.h"

namespace candela_obj {
namespace {

class UseReader {
  public:
    UseReader(Statement& statement, IgnoredStatements& ignored, TextureInfo& use)
        : statement_(statement), ignored_(ignored), use_(use) {}

    void readOptions() {
        while (statement_.rest().starts_with('-')) {
            const std::string_view option = *statement_.word();
            if (option == "-o")
                readPair(use_.offset);
            else if (option == "-s")
                readPair(use_.scale);
            else if (option == "-clamp")
                use_.clamp = readSwitch();
            else if (option == "-bm")
                use_.multiplier = statement_.needNumber();
            else if (option == "-imfchan")
                use_.channel = readChannel();
            else
                passOver(option);
        }
    }

  private:
    /// The next word, if it is a number and not all that is left: that is the file name.
    std::optional<float> optionalNumber() {
        Statement ahead = statement_;
        const auto word = ahead.word();
        if (!word || !numberIn(*word) || ahead.rest().empty()) return std::nullopt;
        statement_ = ahead;
        return statement_.number(*word, largest);
    }

    /// One to three numbers, the third of which is for solid textures.
    void readPair(float (&pair)[2]) {
        pair[0] = statement_.needNumber(largest);
        if (const auto second = optionalNumber())
            pair[1] = *second;
        else
            return;
        optionalNumber();
    }

    bool readSwitch() {
        const std::string_view word = statement_.needWord("on or off");
        if (word != "on" && word != "off")
            statement_.fail("'" + readable(std::string(word)) + "', but on or off was expected");
        return word == "on";
    }

    Channel readChannel() {
        const std::string_view word = statement_.needWord("a channel");
        if (word == "r") return Channel::red;
        if (word == "g") return Channel::green;
        if (word == "b") return Channel::blue;
        if (word == "m") return Channel::matte;
        if (word == "l") return Channel::luminance;
        statement_.fail("-imfchan " + readable(std::string(word)) + ", but r, g, b, m or l was expected");
    }

    void passOver(std::string_view option) {
        static constexpr std::string_view known[] = {"-blendu", "-blendv", "-boost",  "-cc",
                                                     "-mm",     "-t",      "-texres", "-type"};
        const bool isKnown = std::find(std::begin(known), std::end(known), option) != std::end(known);
        ignored_.count(isKnown ? "not used" : "not known", "option " + std::string(option),
                       statement_.line());
        if (isKnown && option != "-t" && option != "-mm") {
            statement_.needWord("a value");
            return;
        }
        if (passSwitch()) return;
        while (optionalNumber()) continue;
    }

    bool passSwitch() {
        Statement ahead = statement_;
        const auto word = ahead.word();
        if (word != "on" && word != "off") return false;
        statement_ = ahead;
        return true;
    }

    // Beyond that an offset leaves nothing of a coordinate's fraction.
    static constexpr double largest = 1e6;

    Statement& statement_;
    IgnoredStatements& ignored_;
    TextureInfo& use_;
};

}  // namespace

bool TextureInfo::samplesLike(const TextureInfo& other) const {
    return std::equal(offset, offset + 2, other.offset) && std::equal(scale, scale + 2, other.scale) &&
           clamp == other.clamp;
}

TextureInfo parseTextureInfo(Statement& statement, const std::string& materialFile,
                             IgnoredStatements& ignored) {
    TextureInfo use;
    use.element = statement.place() + ": " + std::string(statement.keyword());
    UseReader(statement, ignored, use).readOptions();
    if (statement.rest().empty()) statement.fail("a file name was expected");
    use.file = besideFile(materialFile, statement.rest());
    return use;
}

}  // namespace candela_obj
