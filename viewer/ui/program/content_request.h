#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/base/model_search.h"
#include "core/base/result.h"
#include "core/net/endpoint.h"
#include "viewer/backdrop/backdrop.h"
#include "viewer/ui/live/keep_limits.h"

namespace rocinante {

/// What the window shall show, as arguments of the program say it or as opened in the window.
struct ContentRequest {
  std::filesystem::path cell;    ///< empty: nothing, or the cell that the log carries
  std::filesystem::path log;     ///< empty: none
  std::filesystem::path beside;  ///< another log of the cell, shown as ghosts; empty: none
  std::string align;             ///< of it, for alignBeside()
  bool beside_alone = false;     ///< only `beside` is read, for what is shown, which is `log`
  /// Shown with a log that carries no cell; empty: there is none.
  std::filesystem::path fallback_cell;
  std::optional<std::vector<Endpoint>> live;
  /// Endpoints as they were typed, which become `live` when it is loaded: a name is looked up.
  std::vector<std::string> connect;
  /// What becomes of a live session that is shown: it goes on behind what is shown then, ends, or
  /// goes on with this cell. Holds for one change: LeftSessions::leave() makes it the first again.
  enum class Leaving {
    stays_behind,
    ends_unheard,  ///< one that has heard something by then stays instead
    ends,          ///< with what it kept
    goes_along,
  } leaving = Leaving::stays_behind;
  std::string trust;
  std::string decoders;             ///< of a live session: a file; empty: those of the cell
  KeepLimits keep;                  ///< of a live session
  std::vector<std::string> joints;  ///< moved by hand: a device's values, as --joints
  std::string drive, drive_as;      ///< an endpoint and a SOURCE for joints by hand; empty: neither
  std::string publish, publish_as;  ///< an endpoint and a SOURCE for other windows; empty: neither
  std::vector<std::string> hide, show, styles;
  std::string camera, at;
  bool at_event = false;  ///< `at` is the name of an event, never a time
  BackdropRequest backdrop;
  ModelSearch where;

  bool empty() const { return cell.empty() && log.empty() && !live && connect.empty(); }
  /// The file that gives it its name; empty: it has none.
  const std::filesystem::path& named() const {
    if (beside_alone) return beside;
    return log.empty() ? cell : log;
  }
  /// For the user: the name of that file, or else its endpoints.
  std::string title() const;
};

/// Endpoints as they were typed, for the user: plain, with a blank between two, without passwords.
std::string typedText(const std::vector<std::string>& endpoints);
/// Those of a live session, with a blank between two; empty: it is none.
std::string endpointsText(const ContentRequest& request);

/// What files that were dropped on a window or opened in it mean, while `shown` is there: a cell or
/// model, a log, or one of each; a second log is beside the first. A live session goes on with a
/// cell that is opened alone. bad_argument with a sentence otherwise.
Result<ContentRequest> requestOf(const std::vector<std::filesystem::path>& files,
                                 const ContentRequest& shown);
/// Another log beside that of `shown`. bad_argument or not_found with a sentence.
Result<ContentRequest> besideOf(const std::filesystem::path& file, std::string align,
                                const ContentRequest& shown);
/// A live session of the cell that is shown, with the program's options for it.
ContentRequest connectionOf(std::vector<std::string> endpoints, const ContentRequest& shown);
/// The cell of a live session at rest. `forgets`: the session ends even if it has heard something.
ContentRequest withoutConnection(const ContentRequest& shown, bool forgets);
/// Makes `live` of what was typed to connect to, if anything was: looks up names. bad_argument, or
/// refused when a name is not found.
Status readEndpoints(ContentRequest& request);

}  // namespace rocinante
