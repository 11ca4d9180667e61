// The part of ViewModel for what is found out in the background.
#include "viewer/ui/model/view_model.h"

namespace rocinante {

LogStudy* ViewModel::study() {
  if (!session_ || study_delayed) return nullptr;
  if (!study_) {
    // A growing session is read from its first piece on.
    const LogReader& log = log_grows_ ? session_->logAt(session_->start()) : session_->log();
    study_ = std::make_unique<LogStudy>(*cell_, log.name(), log_grows_);
  }
  study_->waits = study_waits;
  return study_.get();
}

LogStudy* ViewModel::studyBeside() {
  if (!beside_ || study_delayed) return nullptr;
  if (!study_beside_) {
    study_beside_ = std::make_unique<LogStudy>(*cell_, beside_->session().log().name());
  }
  study_beside_->waits = study_waits;
  return study_beside_.get();
}

const PartingStudy* ViewModel::partings() {
  if (!beside_ || study_delayed) return nullptr;
  if (!partings_) {
    partings_ = std::make_unique<PartingStudy>(
        *cell_, session_->log().name(), beside_->session().log().name(), beside_->alignment());
  }
  if (study_waits) partings_->wait();
  return partings_.get();
}

void ViewModel::dropBesideStudies() {
  viewer.picture_beside.reset();
  study_beside_.reset();
  partings_.reset();
}

const FindingsStudy* ViewModel::findings() {
  // What is still being written would be judged by its first moments.
  if (!session_ || !viewer.findings_wanted || log_grows_) return nullptr;
  if (!judged_) {
    // One thread after the other: two cores also have to draw.
    if (viewer.picture == nullptr || (study_ && study_->isBusy())) return nullptr;
    judged_ = std::make_unique<FindingsStudy>(*cell_, session_->log().name());
  }
  if (study_waits) judged_->wait();
  judged_seen_ = judged_->isFinished();
  return judged_.get();
}

void ViewModel::listenAround() {
  if (!survey_) {
    survey_ = std::make_unique<EndpointSurvey>(usualEndpoints());
  } else if (!survey_->isListening()) {
    survey_->listen();
  }
  if (study_waits) survey_->wait();
}

bool ViewModel::hasStudyNews() const {
  return (survey_ && survey_->takeNews()) || (nearest_ && nearest_->takeNews()) ||
         (study_ && study_->hasNews()) || (judged_ && !judged_seen_ && judged_->isFinished()) ||
         (study_beside_ && study_beside_->hasNews()) || (partings_ && partings_->takeNews());
}

bool ViewModel::isStudyBusy() const {
  return (survey_ && survey_->isListening()) || (nearest_ && nearest_->isBusy()) ||
         (study_ && study_->isBusy()) || (judged_ && !judged_->isFinished()) ||
         (study_beside_ && study_beside_->isBusy()) || (partings_ && !partings_->isFinished()) ||
         (study_ && viewer.findings_wanted && !judged_ && !log_grows_);
}

bool ViewModel::lookForNearest() {
  NearestQuery wish{selected.device, selected.link, viewer.reference.device, viewer.reference.link};
  // A device is not measured against a part of itself, only a link against another.
  const bool are_links = !wish.link.empty() && !wish.other_link.empty();
  if (wish.other == wish.device && (!are_links || wish.link == wish.other_link)) {
    wish.other.clear();
    wish.other_link.clear();
  }
  const bool wanted = viewer.nearest_wanted && !wish.device.empty();
  if (wanted) {
    if (!nearest_) nearest_ = std::make_unique<NearestStudy>(*cell_);
    if (nearest_asked_ != wish || nearest_is_old_) {
      if (study_waits) nearest_->wait();
      if (nearest_->ask(wish, *state_, shownTime())) {
        nearest_asked_ = wish;
        nearest_is_old_ = false;
      }
      if (study_waits) nearest_->wait();
    }
  }
  nearest_found_ = wanted ? nearest_->found() : std::nullopt;
  if (nearest_found_ && nearest_found_->wish != wish) nearest_found_.reset();
  // A line of another moment would end in the air.
  std::optional<ClearanceLine> line;
  if (nearest_found_ && !nearest_found_->other.empty() && !nearest_is_old_ &&
      nearest_found_->moment == shownTime()) {
    const NearestFound& found = *nearest_found_;
    line = ClearanceLine{found.on_device, found.on_other, found.distance_m, found.distance_m > 0};
  }
  const bool changed = line != extras_.nearest;
  extras_.nearest = line;
  return changed;
}

}  // namespace rocinante
