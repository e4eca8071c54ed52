// Lists of pictures that several processes share: shards, pictures that are there already, placeholders, and
// what is told of failures and signals.

#include "command.h"
#include "picture_reader.h"
#include "sample_scene.h"
#include "temporary_folder.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <fstream>
#include <iterator>
#include <sstream>
#include <thread>

namespace {

using Json = nlohmann::json;
using Names = std::vector<std::string>;

class Farm : public testing::Test {
  protected:
    Farm() { folder.write("square.gltf", sampleScene()); }

    CommandResult render(std::vector<std::string> arguments,
                         std::vector<std::string> environment = {}) const {
        arguments.insert(arguments.begin(), {"square.gltf", "--samples", "1"});
        if (std::ranges::find(arguments, "--size") == arguments.end())
            arguments.insert(arguments.end(), {"--size", "16x16"});
        return runCommand(arguments, {.folder = folder.path(), .environment = std::move(environment)});
    }
    std::string bytes(const std::string& name) const {
        std::ifstream stream(folder / name, std::ios::binary);
        return {std::istreambuf_iterator<char>(stream), {}};
    }
    /// The names of the folder without the scene.
    Names pictures() const {
        Names names = folder.names();
        std::erase(names, "square.gltf");
        return names;
    }

    TemporaryFolder folder;
};

TEST_F(Farm, ShardsDrawEveryPictureOnceAndTheSame) {
    expectSuccess(render({"-o", "all##.exr", "--frames", "0-6"}));
    for (const char* shard : {"1/3", "2/3", "3/3"})
        expectSuccess(
            render({"-o", std::string("s") + shard[0] + "-##.exr", "--frames", "0-6", "--shard", shard}));
    EXPECT_EQ(pictures(), (Names{"all00.exr", "all01.exr", "all02.exr", "all03.exr", "all04.exr", "all05.exr",
                                 "all06.exr", "s1-00.exr", "s1-03.exr", "s1-06.exr", "s2-01.exr", "s2-04.exr",
                                 "s3-02.exr", "s3-05.exr"}));
    for (const std::string& name : pictures()) {
        if (name.starts_with("s")) {
            EXPECT_EQ(bytes(name), bytes("all" + name.substr(3))) << name;
        }
    }
    EXPECT_NE(bytes("all00.exr"), bytes("all01.exr"));
}

TEST_F(Farm, AListDrawsTheSamePicturesAsARange) {
    expectSuccess(render({"-o", "a#.png", "--frames", "0-3", "--encode-threads", "3"}));
    expectSuccess(render({"-o", "b#.png", "--frames", "3,1-2,0", "--threads", "1"}));
    for (const char* number : {"0", "1", "2", "3"})
        EXPECT_EQ(bytes("a" + std::string(number) + ".png"), bytes("b" + std::string(number) + ".png"));
}

TEST_F(Farm, AShardMayBeEmpty) {
    const CommandResult result = render({"-o", "f#.png", "--frames", "0-1", "--shard", "3/3"});
    expectSuccess(result);
    EXPECT_EQ(result.out, "this shard has no picture\n");
    EXPECT_TRUE(pictures().empty());
}

TEST_F(Farm, SlurmNamesTheShard) {
    // Tasks 3, 5 and 7: the second of three.
    expectSuccess(render({"-o", "f#.png", "--frames", "0-5", "--shard", "slurm"},
                         {"SLURM_ARRAY_TASK_ID=5", "SLURM_ARRAY_TASK_COUNT=3", "SLURM_ARRAY_TASK_MIN=3",
                          "SLURM_ARRAY_TASK_STEP=2"}));
    EXPECT_EQ(pictures(), (Names{"f1.png", "f4.png"}));
    expectUsageError(render({"--shard", "slurm"}), "SLURM_ARRAY_TASK_ID is not set");
    // Of the array 3,7 the count is 2, and neither says what the other task is.
    expectUsageError(render({"--shard", "slurm"}, {"SLURM_ARRAY_TASK_ID=7", "SLURM_ARRAY_TASK_COUNT=2",
                                                   "SLURM_ARRAY_TASK_MIN=3", "SLURM_ARRAY_TASK_STEP=1"}),
                     "--shard I/N");
}

TEST_F(Farm, SkipExistingLeavesWholePicturesOnly) {
    for (const std::string ending : {".png", ".exr"}) {
        expectSuccess(render({"-o", "f#" + ending, "--frames", "0-3"}));
        const std::string whole = bytes("f0" + ending), other = bytes("f3" + ending);
        folder.write("f1" + ending, bytes("f1" + ending).substr(0, whole.size() - 1));
        folder.write("f2" + ending, "");
        folder.write("f3" + ending, whole);
        const CommandResult result = render({"-o", "f#" + ending, "--frames", "0-3", "--skip-existing"});
        expectSuccess(result);
        EXPECT_NE(result.out.find("left out 2"), std::string::npos) << result.out;
        EXPECT_EQ(bytes("f3" + ending), whole) << "a whole one stays, whatever it shows";
        expectSuccess(render({"-o", "f#" + ending, "--frames", "3"}));
        EXPECT_EQ(bytes("f3" + ending), other);
        EXPECT_NE(bytes("f1" + ending), bytes("f2" + ending));
    }
    EXPECT_EQ(readPng(folder / "f1.png").width, 16);
    EXPECT_EQ(readExr(folder / "f2.exr").width, 16);
}

TEST_F(Farm, NothingLeftToDoIsSaid) {
    expectSuccess(render({"-o", "f#.png", "--frames", "0-1"}));
    // No device of this number: none is opened.
    const CommandResult result =
        render({"-o", "f#.png", "--frames", "0-1", "--skip-existing", "--device", "1000"});
    expectSuccess(result);
    EXPECT_EQ(result.out, "left out 2 pictures, wrote none\n");
}

TEST_F(Farm, CompressedExrsOfEveryKindAreWhole) {
    for (const char* compression : {"none", "zip", "piz", "dwaa"}) {
        const std::string name = std::string(compression) + ".exr";
        // 70 rows are several chunks of each kind, the last of them smaller.
        expectSuccess(render(
            {"-o", name, "--compression", compression, "--exr", "half", "--aov", "Z", "--size", "16x70"}));
        folder.write("short-" + name, bytes(name).substr(0, bytes(name).size() - 1));
        EXPECT_EQ(render({"-o", name, "--skip-existing"}).out, "left out 1 picture, wrote none\n") << name;
        EXPECT_TRUE(render({"-o", "short-" + name, "--skip-existing"}).out.starts_with("wrote")) << name;
        const ExrPicture picture = readExr(folder / name);
        EXPECT_FALSE(picture.floats) << "R is half";
        // The square is 3 m from the camera.
        EXPECT_NEAR(picture.at("Z", 8, 35), 3.0f, 1.0e-5f);
    }
}

/// Locks a file as another process would.
class LockedFile {
  public:
    explicit LockedFile(const std::string& path)
        : descriptor_(open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666)) {
        struct flock whole {};
        whole.l_type = F_WRLCK;
        EXPECT_EQ(fcntl(descriptor_, F_OFD_SETLK, &whole), 0);
    }
    LockedFile(const LockedFile&) = delete;
    LockedFile& operator=(const LockedFile&) = delete;
    ~LockedFile() { close(descriptor_); }

  private:
    int descriptor_;
};

TEST_F(Farm, PlaceholdersKeepOthersOut) {
    const LockedFile other(folder / "f1.png.lock");
    folder.write("f2.png.lock", "of a process that was killed\n");
    const CommandResult result = render({"-o", "f#.png", "--frames", "0-2", "--placeholders"});
    expectSuccess(result);
    EXPECT_NE(result.out.find("left out 1"), std::string::npos) << result.out;
    EXPECT_EQ(pictures(), (Names{"f0.png", "f1.png.lock", "f2.png"}));
}

TEST_F(Farm, ProcessesThatShareAListDrawEachPictureOnce) {
    // Two at once: each leaves out what the other draws or has drawn.
    CommandResult results[2];
    {
        std::vector<std::jthread> processes;
        for (CommandResult& result : results)
            processes.emplace_back([&] {
                result =
                    render({"-o", "f##.png", "--frames", "0-29", "--placeholders", "--progress", "json"});
            });
    }
    int written = 0;
    for (const CommandResult& result : results) {
        expectSuccess(result);
        std::istringstream lines(result.err);
        for (std::string line; std::getline(lines, line);) written += Json::parse(line)["event"] == "written";
    }
    EXPECT_EQ(written, 30);
    EXPECT_EQ(pictures().size(), 30u);
}

TEST_F(Farm, KeepGoingDrawsTheOthersAndNamesWhatIsMissing) {
    std::filesystem::create_directory(folder.path() / "f1.png");
    std::filesystem::create_directory(folder.path() / "f3.png");
    const CommandResult result = render({"-o", "f#.png", "--frames", "0-4", "--keep-going", "--quiet"});
    EXPECT_EQ(result.exitCode, 1);
    EXPECT_EQ(result.err,
              "candela-render: f1.png: is a folder\n"
              "candela-render: f3.png: is a folder\n"
              "candela-render: 2 of 5 pictures are missing: f1.png, f3.png\n");
    EXPECT_EQ(pictures(), (Names{"f0.png", "f1.png", "f2.png", "f3.png", "f4.png"}));
}

TEST_F(Farm, FoldersAreMadeOnRequest) {
    expectFault(render({"-o", "a/b/f#.png", "--frames", "1"}), "a/b/f1.png", "the folder a/b does not exist");
    expectSuccess(render({"-o", "a/b/f#.png", "--frames", "1", "--mkdir"}));
    EXPECT_EQ(readPng(folder / "a/b/f1.png").width, 16);
}

TEST_F(Farm, ProgressIsAnObjectALine) {
    expectSuccess(render({"-o", "f#.png", "--frames", "0"}));
    const CommandResult result =
        render({"-o", "f#.png", "--frames", "0-2", "--skip-existing", "--progress", "json", "--stats", "-"});
    expectSuccess(result);
    std::vector<Json> events;
    std::istringstream lines(result.err);
    for (std::string line; std::getline(lines, line);) {
        const Json event = Json::parse(line);
        EXPECT_EQ(event["of"], event["event"] == "note" ? event["of"] : Json(3));
        EXPECT_GT(event["seconds"].get<double>(), 0.0);
        EXPECT_GT(event["memory_bytes"].get<std::uint64_t>(), 1u << 20);
        if (event["event"] != "note") events.push_back(event);
    }
    ASSERT_EQ(events.size(), 5u) << result.err;
    EXPECT_EQ(events[0]["event"], "begin");
    EXPECT_EQ(events[1]["event"], "skipped");
    EXPECT_EQ(events[1]["picture"], "f0.png");
    for (int i : {2, 3}) {
        EXPECT_EQ(events[i]["event"], "written");
        EXPECT_EQ(events[i]["done"], i);
        EXPECT_NEAR(events[i]["share"].get<double>(), i / 3.0, 1.0e-12);
        EXPECT_EQ(events[i]["camera"], "front");
    }
    EXPECT_EQ(events[4]["event"], "end");
    const Json pictures = Json::parse(result.out)["pictures"];
    ASSERT_EQ(pictures.size(), 2u);
    EXPECT_EQ(pictures[0]["picture"], "f1.png");
    EXPECT_EQ(pictures[1]["frame"], 2);
    EXPECT_EQ(pictures[1]["bytes"], bytes("f2.png").size());
    EXPECT_GT(pictures[1]["draw_ms"].get<double>(), 0.0);
}

TEST_F(Farm, TerminationSaysWhatIsDone) {
    const auto terminate = [&](int child) {
        for (int tries = 0; tries < 6000 && pictures().size() < 3; ++tries)
            std::this_thread::sleep_for(std::chrono::milliseconds(10));
        kill(child, SIGTERM);
    };
    const CommandResult result = runCommand({"square.gltf", "-o", "f#.png", "--frames", "0-100000", "--size",
                                             "64x64", "--placeholders", "--quiet"},
                                            {.folder = folder.path(), .whileRunning = terminate});
    EXPECT_EQ(result.signal, SIGTERM);
    const std::size_t count = pictures().size();
    EXPECT_GE(count, 3u);
    EXPECT_EQ(result.err, "candela-render: interrupted by SIGTERM: of 100001 pictures " +
                              std::to_string(count) + " are written\n");
    for (const std::string& name : pictures()) EXPECT_EQ(readPng(folder / name).width, 64) << name;
}

TEST_F(Farm, TheDeviceMayComeFromTheEnvironment) {
    expectUsageError(render({"-o", "a.png"}, {"CANDELA_DEVICE=gpu"}), "CANDELA_DEVICE \"gpu\"");
    const CommandResult missing = render({"-o", "a.png", "--quiet"}, {"CANDELA_DEVICE=1000"});
    EXPECT_EQ(missing.exitCode, 1);
    EXPECT_NE(missing.err.find("1000"), std::string::npos) << missing.err;
    expectSuccess(render({"-o", "a.png", "--device", "software"}, {"CANDELA_DEVICE=1000"}));
    expectSuccess(render({"-o", "a.png", "--device", "auto", "--shard", "1/1"}));
}

}  // namespace
