#include "viewer/ui/program/picture_rest.h"

namespace rocinante {

Result<PictureRest::News> PictureRest::step(SteadyTime now, bool is_empty, bool is_announced) {
  stepped_ = now;
  if (warmsUp(is_empty)) {
    const bool more = warm_up_.advance(picture_, detail_);
    if (warm_up_.done()) picture_.warmedUp();
    if (more) return News::none;
  }
  if (detail_.fixed()) return News::none;
  const bool due = picture_.refinesAt(now);
  if (due && !is_announced) return News::begins;
  const auto whole = picture_.refine(now);
  if (!whole.ok()) return whole.error();
  if (*whole) return News::whole;
  return due && !picture_.refinesAt(now) ? News::ends : News::none;
}

}  // namespace rocinante
