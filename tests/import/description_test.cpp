// The rules of a plugin's description, broken one at a time.
#include "import/plugin_file.h"

#include <gtest/gtest.h>

#include <sys/mman.h>
#include <unistd.h>

#include <cstddef>
#include <cstring>
#include <stdexcept>
#include <string>
#include <vector>

namespace candela {
namespace {

candela_status importNothing(const candela_host*, const candela_request*) {
    return CANDELA_OK;
}

candela_status refineNothing(const candela_refinement*, const candela_cage*, std::uint32_t) {
    return CANDELA_OK;
}

class Description : public testing::Test {
  protected:
    Description() { plugin.importer = &importer; }

    PluginReport check(const candela_plugin* description) {
        PluginReport report;
        LoadedPlugin loaded;
        checkDescription(description, loaded, report);
        return report;
    }

    void expectBad(const std::string& detail) {
        const PluginReport report = check(&plugin);
        EXPECT_STREQ(toString(report.state), toString(PluginState::badDescription));
        EXPECT_NE(report.detail.find(detail), std::string::npos) << report.detail;
    }

    const char* extensions[3] = {"one", "two", nullptr};
    const char* schemes[2] = {"sample", nullptr};
    candela_importer importer{sizeof(candela_importer), extensions, schemes, importNothing, 0, nullptr};
    candela_plugin plugin{sizeof(candela_plugin),
                          CANDELA_PLUGIN_MAJOR,
                          CANDELA_PLUGIN_MINOR,
                          "name",
                          "1.0",
                          "a line",
                          nullptr,
                          nullptr,
                          nullptr};
    candela_subdivider subdivider{sizeof(candela_subdivider), refineNothing};
};

TEST_F(Description, ThatIsValidIsLoaded) {
    const PluginReport report = check(&plugin);
    EXPECT_EQ(report.state, PluginState::loaded) << report.detail;
    EXPECT_EQ(report.extensions, (std::vector<std::string>{"one", "two"}));
}

TEST_F(Description, OfALaterMinorVersionIsLoaded) {
    struct Longer {
        candela_plugin plugin;
        void* added;
    } longer{plugin, nullptr};
    longer.plugin.struct_size = sizeof longer;
    longer.plugin.minor = CANDELA_PLUGIN_MINOR + 7;
    EXPECT_EQ(check(&longer.plugin).state, PluginState::loaded);
}

TEST_F(Description, OfAnotherMajorVersionIsNotReadFurther) {
    plugin.major = CANDELA_PLUGIN_MAJOR + 1;
    plugin.name = nullptr;
    const PluginReport report = check(&plugin);
    EXPECT_EQ(report.state, PluginState::wrongVersion);
    EXPECT_EQ(report.name, "");
}

TEST_F(Description, StructSizeTooSmall) {
    plugin.struct_size = offsetof(candela_plugin, subdivider) - 8;
    expectBad("struct_size of its candela_plugin is 40, but version 1.0 has 48 bytes");
    plugin.struct_size = 4;
    expectBad("does not even hold the version");
    plugin.struct_size = sizeof(candela_plugin);
    importer.struct_size = 8;
    expectBad("struct_size of its candela_importer is 8, but version 1.0 has");
    importer.struct_size = sizeof importer;
    plugin.subdivider = &subdivider;
    subdivider.struct_size = 8;
    expectBad("struct_size of its candela_subdivider is 8, but version 1.1 has");
}

// A description that ends before an unreadable page: reading beyond it crashes.
class GuardedMemory {
  public:
    GuardedMemory() {
        pages_ = ::mmap(nullptr, 2 * page_, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
        if (pages_ == MAP_FAILED || ::mprotect(end(), page_, PROT_NONE) != 0)
            throw std::runtime_error("no memory can be mapped");
    }
    ~GuardedMemory() { ::munmap(pages_, 2 * page_); }
    GuardedMemory(const GuardedMemory&) = delete;
    GuardedMemory& operator=(const GuardedMemory&) = delete;

    /// The first `size` bytes of `plugin`, just before the end.
    const candela_plugin* place(candela_plugin plugin, std::uint32_t size) {
        plugin.struct_size = size;
        std::memcpy(end() - size, &plugin, size);
        return reinterpret_cast<const candela_plugin*>(end() - size);
    }

  private:
    char* end() { return static_cast<char*>(pages_) + page_; }

    const std::size_t page_ = static_cast<std::size_t>(::sysconf(_SC_PAGESIZE));
    void* pages_ = nullptr;
};

TEST_F(Description, NothingIsReadBeyondStructSize) {
    GuardedMemory memory;
    for (const std::uint32_t size : {4u, 8u, 16u, 24u, 40u})
        EXPECT_EQ(check(memory.place(plugin, size)).state, PluginState::badDescription) << size;
}

TEST_F(Description, OfTheFirstVersionIsLoaded) {
    GuardedMemory memory;
    const PluginReport report = check(memory.place(plugin, offsetof(candela_plugin, subdivider)));
    EXPECT_EQ(report.state, PluginState::loaded) << report.detail;
    EXPECT_FALSE(report.subdivides);
}

TEST_F(Description, Names) {
    plugin.name = nullptr;
    expectBad("its name is NULL");
    for (const char* name : {"", "Upper", "two words", "a/b", "n\xC3\xA4me"}) {
        plugin.name = name;
        expectBad("is not made of a to z");
    }
    const std::string longName(65, 'a');
    plugin.name = longName.c_str();
    expectBad("its name is longer than 64 bytes");
}

TEST_F(Description, VersionAndText) {
    plugin.version = nullptr;
    expectBad("its version is NULL");
    plugin.version = "1\n2";
    expectBad("its version is not one line");
    plugin.version = "1";
    plugin.description = nullptr;
    expectBad("its description is NULL");
    plugin.description = "\xFF";
    expectBad("its description is not one line of UTF-8");
}

TEST_F(Description, Services) {
    plugin.importer = nullptr;
    expectBad("it offers no service");
    plugin.importer = &importer;
    importer.import_scene = nullptr;
    expectBad("import_scene of its importer is NULL");
    plugin.importer = nullptr;
    plugin.subdivider = &subdivider;
    subdivider.refine = nullptr;
    expectBad("refine of its subdivider is NULL");
}

TEST_F(Description, OfASubdividerAlone) {
    plugin.importer = nullptr;
    plugin.subdivider = &subdivider;
    const PluginReport report = check(&plugin);
    EXPECT_EQ(report.state, PluginState::loaded) << report.detail;
    EXPECT_TRUE(report.subdivides);
    EXPECT_TRUE(report.extensions.empty());
    EXPECT_TRUE(report.schemes.empty());
}

TEST_F(Description, OfBothServices) {
    plugin.subdivider = &subdivider;
    const PluginReport report = check(&plugin);
    EXPECT_EQ(report.state, PluginState::loaded) << report.detail;
    EXPECT_TRUE(report.subdivides);
    EXPECT_EQ(report.schemes, std::vector<std::string>{"sample"});
}

TEST_F(Description, ExtensionsAndSchemes) {
    importer.extensions = importer.schemes = nullptr;
    expectBad("takes no file name ending and no scheme");
    const char* const none[] = {nullptr};
    importer.schemes = none;
    expectBad("takes no file name ending and no scheme");
    for (const char* ending : {".glb", "GLB", "", "tar.gz"}) {
        const char* const list[] = {ending, nullptr};
        importer.extensions = list;
        expectBad("the file name ending");
    }
    importer.extensions = nullptr;
    for (const char* scheme : {"c", "1st", "Upper", "a:b"}) {
        const char* const list[] = {scheme, nullptr};
        importer.schemes = list;
        expectBad("the scheme '");
    }
}

TEST_F(Description, UnterminatedList) {
    const std::vector<const char*> unterminated(100, "same");
    importer.extensions = unterminated.data();
    expectBad("it lists more than 64 file name endings");
}

}  // namespace
}  // namespace candela
