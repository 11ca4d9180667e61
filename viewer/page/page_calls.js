"use strict";
// The calls of viewer/web/web_main.cpp, with JavaScript's own values.
function rocinanteCalls(viewer) {
  const taken = (bytes) => {
    const at = viewer._malloc(Math.max(bytes.length, 1));
    viewer.HEAPU8.set(bytes, at);
    return at;
  };
  const text = (at) => viewer.UTF8ToString(at);
  const json = (at) => JSON.parse(text(at));
  const withText = (given, use) => {
    const at = taken(new TextEncoder().encode(given + "\0"));
    const answer = use(at);
    viewer._free(at);
    return answer;
  };
  return {
    // The log is in the viewer's memory, which the viewer then owns. Of one that is only begun, its beginning
    // is shown until it is whole.
    open(cell, log) {
      const at = taken(cell);
      const fault = text(viewer._rocinante_open(at, cell.length, log.at, log.size, log.there));
      viewer._free(at);
      return fault;
    },
    openWhole: () => text(viewer._rocinante_open_whole()),
    isFitted: () => viewer._rocinante_is_fitted() !== 0,
    about: () => json(viewer._rocinante_about()),
    events: () => json(viewer._rocinante_events()),
    devices: (ns) => json(viewer._rocinante_devices(ns)),
    poses: (ns) => text(viewer._rocinante_poses(ns)),
    // Care: 0 everything, 1 as much as is drawn in time, 2 little.
    draw: (ns, width, height, scale, care = 0) => text(viewer._rocinante_draw(ns, width, height, scale, care)),
    makeDetail: () => viewer._rocinante_make_detail() !== 0,
    nextPicture: () => viewer._rocinante_next_picture() !== 0,
    frameTook: (ms) => viewer._rocinante_frame_took(ms),
    rung: () => viewer._rocinante_rung(),
    pick: (...all) => json(viewer._rocinante_pick(...all)),
    select: (path) => withText(path, (at) => text(viewer._rocinante_select(at))),
    readPlots: (messages) => viewer._rocinante_read_plots(messages),
    plots: (device, ...all) => withText(device, (at) => json(viewer._rocinante_plots(at, ...all))),
    // The values of a layout, of which the plots have curves; chosen before they are read.
    choosePlots: (names) => names.map((name) => withText(name, (at) => text(viewer._rocinante_choose_plot(at)))).find(Boolean) || "",
    chosen: (ns) => json(viewer._rocinante_chosen(ns)),
    // In place of the cell's own.
    useInsets(insets) {
      viewer._rocinante_clear_insets();
      return insets.map((inset) => withText(inset, (at) => text(viewer._rocinante_add_inset(at)))).find(Boolean) || "";
    },
    fold(log) {
      const at = taken(log);
      const answer = json(viewer._rocinante_fold(at, log.length));
      viewer._free(at);
      return answer;
    },
    warning: () => text(viewer._rocinante_warning()),
    camera: () => text(viewer._rocinante_camera()),
    useCamera: (name) => withText(name, (at) => text(viewer._rocinante_use_camera(at))),
    orbit: (...all) => text(viewer._rocinante_orbit(...all)),
    pan: (...all) => text(viewer._rocinante_pan(...all)),
    zoom: (...all) => text(viewer._rocinante_zoom(...all)),
  };
}
