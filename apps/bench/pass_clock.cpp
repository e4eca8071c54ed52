#include "pass_clock.h"

PassClock::PassClock(const candela::Context& context) : software_(context.isSoftware()) {}

PassClock::~PassClock() {
    glDeleteQueries(static_cast<GLsizei>(queries_.size()), queries_.data());
}

void PassClock::start() {
    names_.clear();
    marks_ = 0;
    mark();
}

void PassClock::lap(const std::string& name) {
    names_.push_back(name);
    mark();
}

void PassClock::mark() {
    const std::size_t index = marks_++;
    if (software_) {
        glFinish();
        walls_.resize(marks_);
        walls_[index] = std::chrono::steady_clock::now();
        return;
    }
    if (queries_.size() < marks_) {
        queries_.push_back(0);
        glCreateQueries(GL_TIMESTAMP, 1, &queries_.back());
    }
    glQueryCounter(queries_[index], GL_TIMESTAMP);
}

double PassClock::at(std::size_t index) {
    if (software_) return std::chrono::duration<double>(walls_[index].time_since_epoch()).count();
    GLuint64 nanoseconds = 0;
    glGetQueryObjectui64v(queries_[index], GL_QUERY_RESULT, &nanoseconds);
    return static_cast<double>(nanoseconds) * 1.0e-9;
}

FrameTimes PassClock::times() {
    FrameTimes times;
    for (std::size_t i = 0; i < names_.size(); ++i)
        times.passes.push_back({names_[i], 1000.0 * (at(i + 1) - at(i))});
    times.frame = 1000.0 * (at(names_.size()) - at(0));
    return times;
}
