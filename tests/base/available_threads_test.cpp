#include "base/available_threads.h"

#include "temporary_folder.h"

#include <candela/threads.h>

#include <gtest/gtest.h>

#include <sched.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fstream>

namespace candela {
namespace {

namespace fs = std::filesystem;

// A temporary folder in place of /sys/fs/cgroup.
class CgroupThreads : public testing::Test {
  protected:
    void write(const fs::path& file, const std::string& text) {
        const fs::path path = folder_.path() / file;
        fs::create_directories(path.parent_path());
        std::ofstream(path) << text << '\n';
    }
    std::optional<unsigned> limit(const std::string& membership) {
        return cgroupThreads(folder_.path(), membership);
    }

    TemporaryFolder folder_;
};

TEST_F(CgroupThreads, AreUnlimitedWithoutGroups) {
    EXPECT_EQ(limit(""), std::nullopt);
    EXPECT_EQ(limit("0::/\n"), std::nullopt);
    EXPECT_EQ(limit("nonsense\n:\n1:2\n"), std::nullopt);
    write("cpu.max", "max 100000");
    EXPECT_EQ(limit("0::/\n"), std::nullopt);
    write("cpu.max", "");
    EXPECT_EQ(limit("0::/\n"), std::nullopt);
}

TEST_F(CgroupThreads, FollowTheQuotaOfVersion2RoundedUp) {
    write("cpu.max", "200000 100000");
    EXPECT_EQ(limit("0::/\n"), 2u);
    write("cpu.max", "150000 100000");
    EXPECT_EQ(limit("0::/\n"), 2u);
    write("cpu.max", "200001 100000");
    EXPECT_EQ(limit("0::/\n"), 3u);
    write("cpu.max", "1000 100000");
    EXPECT_EQ(limit("0::/\n"), 1u);
    write("cpu.max", "99999999999999 100000");
    EXPECT_EQ(limit("0::/\n"), maxThreadCount);
}

TEST_F(CgroupThreads, AreLimitedByTheGroupsAbove) {
    write("slurm/cpu.max", "300000 100000");
    write("slurm/job_7/cpu.max", "max 100000");
    write("slurm/job_7/step_0/cpu.max", "800000 100000");
    EXPECT_EQ(limit("0::/slurm/job_7/step_0\n"), 3u);
    EXPECT_EQ(limit("0::/slurm\n"), 3u);
    EXPECT_EQ(limit("0::/other\n"), std::nullopt);
}

TEST_F(CgroupThreads, FollowTheQuotaOfVersion1) {
    write("cpu,cpuacct/docker/1/cpu.cfs_quota_us", "250000");
    write("cpu,cpuacct/docker/1/cpu.cfs_period_us", "100000");
    EXPECT_EQ(limit("5:memory:/docker/1\n4:cpu,cpuacct:/docker/1\n"), 3u);
    write("cpu,cpuacct/docker/1/cpu.cfs_quota_us", "-1");
    EXPECT_EQ(limit("4:cpu,cpuacct:/docker/1\n"), std::nullopt);
    EXPECT_EQ(limit("4:cpuset:/docker/1\n"), std::nullopt);
}

TEST_F(CgroupThreads, TakeTheRootOfTheMountForAGroupThatIsNotMounted) {
    write("cpu/cpu.cfs_quota_us", "400000");
    write("cpu/cpu.cfs_period_us", "100000");
    EXPECT_EQ(limit("4:cpu,cpuacct:/docker/abc\n"), 4u);
}

TEST_F(CgroupThreads, TakeTheSmallerOfBothVersions) {
    write("unified/a/cpu.max", "500000 100000");
    write("cpu/a/cpu.cfs_quota_us", "600000");
    write("cpu/a/cpu.cfs_period_us", "100000");
    EXPECT_EQ(limit("4:cpu:/a\n0::/a\n"), 5u);
}

// The result of `availableThreads` in a child process whose affinity mask holds one of this process's CPUs.
int availableOnOneCpu() {
    const pid_t child = fork();
    if (child == 0) {
        cpu_set_t all, one;
        CPU_ZERO(&one);
        if (sched_getaffinity(0, sizeof all, &all) != 0) _exit(200);
        int cpu = 0;
        while (cpu < CPU_SETSIZE && !CPU_ISSET(cpu, &all)) ++cpu;
        CPU_SET(cpu, &one);
        if (sched_setaffinity(0, sizeof one, &one) != 0) _exit(201);
        _exit(static_cast<int>(availableThreads()));
    }
    int status = 0;
    waitpid(child, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

TEST(AvailableThreads, FollowTheAffinityMask) {
    EXPECT_EQ(availableOnOneCpu(), 1);
    EXPECT_GE(availableThreads(), 1u);
    EXPECT_LE(availableThreads(), affinityThreads());
}

}  // namespace
}  // namespace candela
