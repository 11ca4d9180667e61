// What the sources of a page refer to and a page does not have: modules, caches, contexts without a
// window, a second session beside the first, clearances. Each answers as it does where its thing
// is missing.

#include "core/base/atomic_file.h"
#include "core/base/cache_folder.h"
#include "viewer/gl/offscreen_context.h"
#include "viewer/picture/picture_module.h"
#include "viewer/view/beside_session.h"
#include "viewer/view/frame_extras.h"

namespace rocinante {
namespace {

Error notHere(std::string what, const std::string& where = {}) {
  return {ErrorKind::unsupported, std::move(what), where};
}

}  // namespace

Result<std::unique_ptr<RenderContext>> makeOffscreenContext(Profile) {
  return notHere("a page draws on its canvas alone");
}

// Nothing is kept.
std::filesystem::path CacheFolder::ofUser(const std::string&) { return {}; }
void CacheFolder::touch(const std::string&) const {}
void CacheFolder::store(const std::string&, std::initializer_list<ByteView>) const {}

Result<std::string> readFile(const std::filesystem::path& path, std::uint64_t) {
  return Error{ErrorKind::not_found, "a page has no files", path.string()};
}
Status writeFileWhole(const std::filesystem::path& path, ByteView, bool, Sync) {
  return notHere("a page has no files", path.string());
}

Result<Picture> readByModule(const std::filesystem::path& path, std::int64_t) {
  return notHere("a page reads PNG alone", path.string());
}
Result<Picture> decodeByModule(ByteView, const std::string& name, std::int64_t) {
  return notHere("a page reads PNG alone", name);
}
Result<FinePicture> readFineByModule(const std::filesystem::path& path, std::int64_t) {
  return notHere("a page reads PNG alone", path.string());
}

Status BesideSession::addGhosts(PosedScene&, LogTime, StateDamage&) {
  return notHere("a page shows one session");
}

// A page's cell has none.
ClearanceGauge::ClearanceGauge(const Cell& cell, Chosen chosen)
    : cell_(cell), chosen_(std::move(chosen)) {}
std::vector<ClearanceLine> clearanceLines(const Cell&, ClearanceGauge&, const SessionState&) {
  return {};
}

}  // namespace rocinante
