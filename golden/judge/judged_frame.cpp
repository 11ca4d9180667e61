#include "golden/judge/judged_frame.h"

#include "core/report/account_wire.h"

namespace rocinante {

std::string_view nameOf(FrameVerdict verdict) {
  switch (verdict) {
    case FrameVerdict::same:
      return "same";
    case FrameVerdict::different:
      return "different";
    case FrameVerdict::missing:
      return "missing";
    case FrameVerdict::unstable:
      return "unstable";
    case FrameVerdict::incomparable:
      return "incomparable";
    case FrameVerdict::expected:
      return "expected";
    case FrameVerdict::unexpected:
      return "unexpected";
  }
  return "incomparable";
}

bool isFine(FrameVerdict verdict) {
  return verdict == FrameVerdict::same || verdict == FrameVerdict::expected;
}

template <class Fields>
void fields(Fields& io, Taken<Fields, Picture>& picture) {
  auto& [width, height, rgba] = picture;
  io(width, height, rgba);
}

template <class Fields>
void fields(Fields& io, Taken<Fields, PictureMask::Part>& part) {
  auto& [name, pixels] = part;
  io(name, pixels);
}

template <class Fields>
void fields(Fields& io, Taken<Fields, Tolerance>& tolerance) {
  auto& [name, exact, tile_mean, tile_over, level, percent] = tolerance;
  io(name, exact, tile_mean, tile_over, level, percent);
}

template <class Fields>
void fields(Fields& io, Taken<Fields, Comparison>& comparison) {
  auto& [verdict, rule, max, worst_x, worst_y, worst_frame, worst_golden, worst_tile_mean,
         worst_tile_x, worst_tile_y, worst_tile_over, differing, over_1, over_2, over_8, over_32,
         masked, fine_differing, fine_max] = comparison;
  io(verdict, rule, max, worst_x, worst_y, worst_frame, worst_golden, worst_tile_mean, worst_tile_x,
     worst_tile_y, worst_tile_over, differing, over_1, over_2, over_8, over_32, masked,
     fine_differing, fine_max);
}

template <class Fields>
void fields(Fields& io, Taken<Fields, AcceptedPicture>& accepted) {
  auto& [key, picture, pixels, inputs, session, accepted_by, accepted_at, reason, areas,
         areas_pixels, cell, decoded, coverage] = accepted;
  io(key, picture, pixels, inputs, session, accepted_by, accepted_at, reason, areas, areas_pixels,
     cell, decoded, coverage);
}

template <class Fields>
void fields(Fields& io, Taken<Fields, RunCoverage>& coverage) {
  auto& [judged, lost, masked, left_out, unstated] = coverage;
  io(judged, lost, masked, left_out, unstated);
}

/// The receiver has the frame from its own suite, and finds out why it differs.
template <class Fields>
void fields(Fields& io, Taken<Fields, JudgedFrame>& judged) {
  auto& [frame, verdict, rule, tolerance, limit_from, expectation, comparison, masks, own_masks,
         coverage, lacks, key, pixels, inputs, session, decoded, golden, drawn, accepted, unmasked,
         areas, thumbnail, why, run_command, approve_command, page, render_ms, judge_ms] = judged;
  io(verdict, rule, tolerance, limit_from, expectation, comparison, masks, own_masks, coverage,
     lacks, key, pixels, inputs, session, decoded, golden, drawn, accepted, unmasked, areas,
     thumbnail, run_command, approve_command, page, render_ms, judge_ms);
}

Bytes wireBytes(const JudgedFrame& judged) {
  StructWriter writer;
  writer(judged);
  return writer.take();
}

Status readWire(ByteView bytes, JudgedFrame& judged) {
  StructReader reader(bytes);
  reader(judged);
  if (reader.readAll()) return {};
  return Error{ErrorKind::damaged, "a job sent an incomplete judgement", {}};
}

}  // namespace rocinante
