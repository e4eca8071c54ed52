#include "gl/pass_timer.h"

#include <algorithm>
#include <string_view>

namespace candela::gl {

void deleteQuery(GLuint name) {
    glDeleteQueries(1, &name);
}

DebugGroup::DebugGroup(const char* name) {
    glPushDebugGroup(GL_DEBUG_SOURCE_APPLICATION, 0, -1, name);
}

DebugGroup::~DebugGroup() {
    glPopDebugGroup();
}

PassTimer::PassTimer(Clock clock) : clock_(clock) {}

void PassTimer::beginFrame() {
    passes_.clear();
}

GLuint PassTimer::query(std::size_t index) {
    while (queries_.size() <= index) {
        GLuint name = 0;
        glCreateQueries(GL_TIMESTAMP, 1, &name);
        queries_.emplace_back(name);
    }
    return queries_[index].name();
}

void PassTimer::begin(const char* name) {
    const auto found = std::ranges::find(passes_, std::string_view(name), &Pass::name);
    current_ = static_cast<std::size_t>(found - passes_.begin());
    if (found == passes_.end()) passes_.push_back({name, 0.0});
    if (clock_ == Clock::gpuQueries) {
        glQueryCounter(query(2 * current_), GL_TIMESTAMP);
        return;
    }
    glFinish();
    start_ = std::chrono::steady_clock::now();
}

void PassTimer::end() {
    if (clock_ == Clock::gpuQueries) {
        glQueryCounter(query(2 * current_ + 1), GL_TIMESTAMP);
        return;
    }
    glFinish();
    passes_[current_].milliseconds =
        std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start_).count();
}

std::vector<std::pair<std::string, double>> PassTimer::results() {
    std::vector<std::pair<std::string, double>> results;
    for (std::size_t i = 0; i < passes_.size(); ++i) {
        if (clock_ == Clock::gpuQueries) {
            GLuint64 from = 0, to = 0;
            glGetQueryObjectui64v(query(2 * i), GL_QUERY_RESULT, &from);
            glGetQueryObjectui64v(query(2 * i + 1), GL_QUERY_RESULT, &to);
            passes_[i].milliseconds = static_cast<double>(to - from) * 1e-6;
        }
        results.emplace_back(passes_[i].name, passes_[i].milliseconds);
    }
    return results;
}

PassTimer::Scope::Scope(PassTimer& timer, const char* name) : timer_(timer), group_(name) {
    timer_.begin(name);
}

PassTimer::Scope::~Scope() {
    timer_.end();
}

}  // namespace candela::gl
