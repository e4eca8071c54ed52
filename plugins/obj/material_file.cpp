#include "material_file.h"

#include <algorithm>
#include <unordered_map>

#include "statement.h"

namespace candela_plugins::obj {

namespace {

class OptionReader {
  public:
    OptionReader(Statement& statement, IgnoredStatements& ignored, TextureInfo& texture)
        : statement_(statement), ignored_(ignored), texture_(texture) {}

    void readOptions() {
        while (statement_.rest().starts_with('-')) {
            const std::string_view option = *statement_.word();
            if (option == "-o")
                readPair(texture_.offset);
            else if (option == "-s")
                readPair(texture_.scale);
            else if (option == "-clamp")
                texture_.clamp = readSwitch();
            else if (option == "-bm")
                texture_.multiplier = statement_.needNumber();
            else if (option == "-imfchan")
                texture_.channel = readChannel();
            else
                skipOption(option);
        }
    }

  private:
    /// The next word, if it is a number and not all that is left: that is the file name.
    std::optional<float> optionalNumber() {
        Statement ahead = statement_;
        const auto word = ahead.word();
        if (!word || !numberIn(*word) || ahead.rest().empty()) return std::nullopt;
        statement_ = ahead;
        return statement_.number(*word, maxOffset);
    }

    /// One to three numbers, the third of which is for solid textures.
    void readPair(float (&pair)[2]) {
        pair[0] = statement_.needNumber(maxOffset);
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

    void skipOption(std::string_view option) {
        static constexpr std::string_view known[] = {"-blendu", "-blendv", "-boost",  "-cc",
                                                     "-mm",     "-t",      "-texres", "-type"};
        const bool isKnown = std::find(std::begin(known), std::end(known), option) != std::end(known);
        ignored_.count(isKnown ? "not used" : "not known", "option " + std::string(option),
                       statement_.line());
        if (isKnown && option != "-t" && option != "-mm") {
            statement_.needWord("a value");
            return;
        }
        if (skipSwitch()) return;
        while (optionalNumber()) continue;
    }

    bool skipSwitch() {
        Statement ahead = statement_;
        const auto word = ahead.word();
        if (word != "on" && word != "off") return false;
        statement_ = ahead;
        return true;
    }

    // With a larger offset a coordinate in single precision has no fraction left.
    static constexpr double maxOffset = 1e6;

    Statement& statement_;
    IgnoredStatements& ignored_;
    TextureInfo& texture_;
};

}  // namespace

bool TextureInfo::hasSameSampling(const TextureInfo& other) const {
    return std::equal(offset, offset + 2, other.offset) && std::equal(scale, scale + 2, other.scale) &&
           clamp == other.clamp;
}

TextureInfo parseTextureInfo(Statement& statement, const std::string& materialFile,
                             IgnoredStatements& ignored) {
    TextureInfo texture;
    texture.element = statement.place() + ": " + std::string(statement.keyword());
    OptionReader(statement, ignored, texture).readOptions();
    if (statement.rest().empty()) statement.fail("a file name was expected");
    texture.file = besideFile(materialFile, statement.rest());
    return texture;
}

namespace {

class MaterialParser {
  public:
    MaterialParser(const std::string& file, std::vector<FileMaterial>& materials)
        : file_(file), materials_(materials) {}

    void read(Statement& statement) {
        const std::string_view keyword = statement.keyword();
        if (keyword == "newmtl") return begin(statement);
        if (isUnused(keyword)) return ignored_.count("not used", keyword, statement.line());
        const auto found = readers().find(keyword);
        if (found == readers().end()) return ignored_.count("not known", keyword, statement.line());
        if (!hasMaterial_) statement.fail("no newmtl precedes it");
        (this->*found->second)(statement);
    }

    void note(const Host& host) const { ignored_.note(host, file_); }

  private:
    using Reader = void (MaterialParser::*)(Statement&);

    static const std::unordered_map<std::string_view, Reader>& readers() {
        using P = MaterialParser;
        static const std::unordered_map<std::string_view, Reader> table{
            {"Kd", &P::readColor<&FileMaterial::diffuse>},
            {"Ke", &P::readColor<&FileMaterial::emission>},
            {"Ns", &P::readExponent},
            {"d", &P::readOpacity},
            {"Tr", &P::readTransparency},
            {"Pr", &P::readFraction<&FileMaterial::roughness>},
            {"Pm", &P::readFraction<&FileMaterial::metallic>},
            {"map_Kd", &P::readMap<&FileMaterial::diffuseMap>},
            {"map_Ke", &P::readMap<&FileMaterial::emissionMap>},
            {"map_d", &P::readMap<&FileMaterial::opacityMap>},
            {"map_Pr", &P::readMap<&FileMaterial::roughnessMap>},
            {"map_Pm", &P::readMap<&FileMaterial::metallicMap>},
            {"norm", &P::readMap<&FileMaterial::normalMap>}};
        return table;
    }

    /// Known statements that are not used. Bump maps hold heights, not normals.
    static bool isUnused(std::string_view keyword) {
        static constexpr std::string_view unused[] = {
            "Ka",       "Ks",     "Tf",     "Ni",      "illum",   "sharpness", "Ps",
            "Pc",       "Pcr",    "aniso",  "anisor",  "map_Ka",  "map_Ks",    "map_Ns",
            "map_Tr",   "map_Ps", "map_Pc", "map_Pcr", "map_aat", "bump",      "map_bump",
            "map_Bump", "disp",   "decal",  "refl",    "map_refl"};
        for (const std::string_view known : unused)
            if (keyword == known) return true;
        return false;
    }

    void begin(Statement& statement) {
        materials_.emplace_back();
        materials_.back().name = statement.rest();
        materials_.back().element =
            statement.place() + ": newmtl '" + readable(std::string(statement.rest())) + "'";
        hasMaterial_ = true;
    }

    template <std::optional<std::array<float, 3>> FileMaterial::*member>
    void readColor(Statement& statement) {
        if (statement.rest().starts_with("spectral") || statement.rest().starts_with("xyz"))
            return ignored_.count("not used", std::string(statement.keyword()) + " other than r g b",
                                  statement.line());
        // Emission has no upper limit but that of the host.
        const bool emits = member == &FileMaterial::emission;
        const double max = emits ? 1e20 : 1.0;
        std::array<float, 3> color{};
        color[0] = number(statement, statement.needWord("r g b"), max);
        // The format lets a single number stand for all three.
        color[1] = color[2] = color[0];
        if (const auto green = statement.word()) {
            color[1] = number(statement, *green, max);
            color[2] = number(statement, statement.needWord("r g b"), max);
        }
        materials_.back().*member = color;
    }

    /// From 0 to `max`.
    static float number(const Statement& statement, std::string_view word, double max) {
        const float value = statement.number(word, max);
        if (value < 0.0f) statement.fail("'" + std::string(word) + "', but 0 or more was expected");
        return value;
    }

    template <std::optional<float> FileMaterial::*member>
    void readFraction(Statement& statement) {
        materials_.back().*member = number(statement, statement.needWord("a number"), 1.0);
    }

    void readExponent(Statement& statement) {
        constexpr double maxExponent = 1e30;
        materials_.back().exponent = number(statement, statement.needWord("a number"), maxExponent);
    }

    void readOpacity(Statement& statement) {
        if (statement.rest().starts_with("-halo")) {
            ignored_.count("not used", "option -halo of d", statement.line());
            statement.word();
        }
        readFraction<&FileMaterial::opacity>(statement);
    }

    /// d takes precedence.
    void readTransparency(Statement& statement) {
        const float transparency = number(statement, statement.needWord("a number"), 1.0);
        if (!materials_.back().opacity) materials_.back().opacity = 1.0f - transparency;
    }

    template <std::optional<TextureInfo> FileMaterial::*member>
    void readMap(Statement& statement) {
        materials_.back().*member = parseTextureInfo(statement, file_, ignored_);
    }

    const std::string& file_;
    std::vector<FileMaterial>& materials_;
    IgnoredStatements ignored_;
    bool hasMaterial_ = false;
};

}  // namespace

void parseMaterialFile(const std::string& name, const Host& host, std::vector<FileMaterial>& materials) {
    const Bytes file = host.readFile(name);
    Lines lines({reinterpret_cast<const char*>(file.data), file.size});
    MaterialParser parser(name, materials);
    while (lines.next()) {
        Statement statement(lines.line(), lines.number(), name);
        parser.read(statement);
    }
    parser.note(host);
}

}  // namespace candela_plugins::obj
