#pragma once

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/bytes.h"
#include "core/base/result.h"
#include "core/cell/view_path.h"
#include "viewer/detail/governor.h"
#include "viewer/render/frame_maker.h"
#include "viewer/shown/turntable.h"
#include "viewer/web/web_live.h"
#include "viewer/web/web_plots.h"

namespace rocinante {

/// A log in memory that malloc() gave, freed with the last copy of this.
class WebLog {
 public:
  WebLog() = default;
  WebLog(std::byte* bytes, std::size_t size) : bytes_(bytes, &std::free), size_(size) {}
  ByteView first(std::size_t count) const { return {bytes_.get(), std::min(count, size_)}; }
  ByteView whole() const { return {bytes_.get(), size_}; }

 private:
  std::shared_ptr<std::byte> bytes_;
  std::size_t size_ = 0;
};

/// A session in a page: a log and a baked cell in memory, and a camera that the mouse moves. The
/// fold, the poses and the frames are those of the programs. One thread.
class WebSession {
 public:
  /// Takes the bytes of a baked cell (docs/baked-cell.md) and of a log, of which the first `there`
  /// are there, and the canvas. damaged, with a sentence for the reader of the page, when either
  /// is. Until openWhole() a session is what the log's beginning says.
  static Result<WebSession> open(Bytes cell, WebLog log, std::size_t there);
  /// All of the log is there.
  Status openWhole();

  /// The same without a log: shows what live() is given.
  static Result<WebSession> openLive(Bytes cell);

  WebSession(WebSession&&) noexcept = default;
  WebSession& operator=(WebSession&&) noexcept = default;

  /// Null with a log.
  WebLive* live() { return live_.get(); }

  /// JSON: start_ns, end_ns (from the session's origin), cameras, the cell's devices
  /// and those of them that have joints.
  std::string aboutJson();
  /// JSON: events and marks, each with ns (from the origin) and text.
  std::string eventsJson();
  /// JSON: devices at that moment, each with its joints' names, values and texts, its signals'
  /// names, texts and kinds, and of the selected link the text of its position in the world, all
  /// worded as in a window. The last has no name and the signals of no device, if there are any. At
  /// most 256 signals of a device and 4,096 of all, with the others as the number `unlisted`, and
  /// 1,024 devices that are not in the cell, behind which one has the number of the others, `more`,
  /// alone. The selected device is always there.
  Result<std::string> devicesJson(std::int64_t ns);
  /// What `rocinante model fk --json` prints for that moment.
  Result<std::string> posesJson(std::int64_t ns);

  /// How much of a picture is drawn.
  enum class Care {
    whole,   ///< everything
    moving,  ///< as much as the machine draws in time, by what frames cost (frameTook())
    first,   ///< little, so that something is there soon: no pictures, insets or highlights
  };
  /// Draws to the canvas, which has that size.
  Status draw(std::int64_t ns, int width, int height, double scale, Care care);
  /// Makes the coarser versions of one more mesh, which frames with Care::moving need; false when
  /// none is left.
  bool makeNextDetail();
  /// Decodes one more picture of surfaces; false when none is left. The first draw() but with
  /// Care::first decodes what is left.
  bool readNextPicture() { return maker_.readNextPicture(); }
  /// What the last frame cost, drawn with Care::moving.
  void frameTook(double ms) { governor_.frameDrawn(ms); }
  /// The rung of detail of moving pictures.
  int rung() const { return governor_.rung(); }

  /// JSON: device and link at that pixel, or null.
  Result<std::string> pickJson(std::int64_t ns, double x, double y, int width, int height);
  /// Outlines a DEVICE or DEVICE/LINK from now on; nothing for an empty path. not_found for one
  /// that neither cell nor session has.
  Status select(const std::string& path);

  /// The insets of the picture from now on, in place of the cell's: none until some are added.
  void clearInsets() { insets_.emplace(); }
  /// As parseInset() takes it.
  Status addInset(const std::string& text);

  /// A value that the plots have, whatever is selected; before the first readPlots().
  Status choosePlot(const std::string& name);
  /// WebPlots::chosenJson() at that moment.
  std::string chosenJson(std::int64_t ns);
  /// Reads on for the plots; the part that is read, 0 to 1.
  Result<double> readPlots(std::uint64_t messages);
  /// WebPlots::lanesJson() of a device, or without a name of none, at that moment.
  Result<std::string> plotsJson(const std::string& device, std::int64_t ns, std::size_t width,
                                double height);

  /// A camera by its name, a viewpoint in numbers, or empty for the cell's first. From then on the
  /// picture is the one of `rocinante render --camera`.
  Status useCamera(const std::string& name);
  /// Moves by hand from where the camera is at that moment; lengths in pixels of the canvas.
  Status orbit(std::int64_t ns, double dx, double dy, int width, int height);
  Status pan(std::int64_t ns, double dx, double dy, int width, int height);
  Status zoomAt(std::int64_t ns, double steps, double right, double down, int width, int height);
  /// The camera in use: its name, or the viewpoint in numbers once it was moved by hand.
  std::string camera() const;
  /// Whether it depends on the whole session.
  bool isFitted() const;

  /// Why a picture or state may lack something: a damaged log. Empty when nothing is known of.
  const std::string& warning() const { return warning_; }

 private:
  WebSession(WebLog log, FrameMaker maker) : log_(std::move(log)), maker_(std::move(maker)) {}

  LogTime momentOf(std::int64_t ns);
  FrameRequest requestAt(std::int64_t ns, int width, int height);
  Result<const SessionState*> stateAt(std::int64_t ns);
  Status takeByHand(std::int64_t ns, int width, int height);
  void note(const StateDamage& damage);

  WebLog log_;                     // the maker's timeline borrows it
  std::unique_ptr<WebLive> live_;  // the maker borrows its state
  FrameMaker maker_;
  std::string camera_;
  std::optional<Turntable> by_hand_;
  std::optional<ViewPath> selected_;
  std::string selected_path_;
  std::optional<std::vector<CellInset>> insets_;  // empty: the cell's
  std::vector<std::string> chosen_;
  std::optional<WebPlots> plots_;  // made on first use
  Governor governor_{Governor::Settings{}};
  std::string warning_;
};

}  // namespace rocinante
