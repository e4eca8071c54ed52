#include "edit_history.h"

#include "render_command_line.h"
#include "scene_loader.h"

#include <type_traits>
#include <utility>

namespace {

/// Options that differ in this text differ in what an edit changes.
std::string textOf(const SceneOptions& options) {
    SceneOptions edited;
    takeEditedOptions(options, edited);
    // The command line has no exposure beside "auto".
    return renderCommandLine(edited) + " " + std::to_string(options.display.exposure);
}

bool join(MaterialEdit& last, MaterialEdit& next) {
    if (last.material != next.material) return false;
    last.after = std::move(next.after);
    return true;
}

bool join(VisibilityEdit& last, VisibilityEdit& next) {
    if (last.node != next.node) return false;
    last.after = next.after;
    return true;
}

bool join(LightsEdit& last, LightsEdit& next) {
    if (last.first != next.first || last.after.size() != next.before.size()) return false;
    last.after = std::move(next.after);
    last.scatteredAfter = next.scatteredAfter;
    last.changedAfter = next.changedAfter;
    return true;
}

bool join(TransformEdit& last, TransformEdit& next) {
    if (last.node != next.node) return false;
    last.after = next.after;
    return true;
}

bool join(LightMotionEdit& last, LightMotionEdit& next) {
    last.after = next.after;
    return true;
}

bool join(OptionsEdit& last, OptionsEdit& next) {
    last.after = std::move(next.after);
    return true;
}

/// Whether `next` has become a part of an edit of the same kind.
bool joinAny(Edit& last, Edit& next) {
    return std::visit(
        [&](auto& one) {
            auto* other = std::get_if<std::decay_t<decltype(one)>>(&next);
            return other != nullptr && join(one, *other);
        },
        last);
}

}  // namespace

void takeEditedOptions(const SceneOptions& from, SceneOptions& to) {
    SceneOptions taken = from;
    takeOptionsOfScene(to, taken);
    taken.scatter = from.scatter;
    taken.width = to.width;
    taken.height = to.height;
    taken.ocio = to.ocio;
    to = std::move(taken);
}

void EditHistory::record(Edit edit) {
    steps_.resize(done_);
    if (!open_) {
        steps_.emplace_back();
        ++done_;
        open_ = true;
    }
    Step& step = steps_.back();
    // Edits of a frame may alternate, such as those of a light and of an option.
    for (auto last = step.rbegin(); last != step.rend(); ++last)
        if (last->index() == edit.index()) {
            if (joinAny(*last, edit)) return;
            break;
        }
    step.push_back(std::move(edit));
}

void EditHistory::watch(const SceneOptions& options) {
    std::string text = textOf(options);
    if (text == watchedText_) return;
    if (!watchedText_.empty()) record(OptionsEdit{watched_, options});
    watched_ = options;
    watchedText_ = std::move(text);
}

void EditHistory::rebase(const SceneOptions& options) {
    watched_ = options;
    watchedText_ = textOf(options);
}

const EditHistory::Step& EditHistory::undo() {
    open_ = false;
    return steps_[--done_];
}

const EditHistory::Step& EditHistory::redo() {
    open_ = false;
    return steps_[done_++];
}

void EditHistory::clear() {
    steps_.clear();
    done_ = 0;
    open_ = false;
}
