# The part of Rocinante that a page needs, as WebAssembly by Debian's emscripten: preset `web`,
# scripts/build_web. One program, rocinante-viewer.js and .wasm, which `rocinante page` packs.
# Libraries lie where scripts/web_libraries puts them.
set(ROCINANTE_WEB_LIBRARIES ${PROJECT_SOURCE_DIR}/build/web-libraries CACHE PATH
  "What scripts/web_libraries made")
set(libraries ${ROCINANTE_WEB_LIBRARIES})
if(NOT EXISTS ${libraries}/include/zstd.h)
  message(FATAL_ERROR "${libraries} lacks the libraries: run scripts/web_libraries")
endif()
set(ROCINANTE_FONT_FILE /usr/share/fonts/truetype/dejavu/DejaVuSans.ttf CACHE FILEPATH
  "The font of every picture's text: DejaVu Sans, built in")

# Their C, each with what it needs to be told.
file(GLOB zstd ${libraries}/zstd/lib/common/*.c ${libraries}/zstd/lib/decompress/*.c)
file(GLOB meshoptimizer ${libraries}/meshoptimizer/src/*.cpp)
list(FILTER meshoptimizer INCLUDE REGEX "/(allocator|indexgenerator|simplifier|vcacheoptimizer|overdrawoptimizer|vfetchoptimizer)\\.cpp$")
set(zlib adler32 crc32 inflate inffast inftrees trees deflate zutil)
list(TRANSFORM zlib PREPEND ${libraries}/zlib/)
list(TRANSFORM zlib APPEND .c)
add_library(rocinante_web_libraries STATIC ${zstd} ${zlib} ${libraries}/spng/spng/spng.c ${meshoptimizer})
target_include_directories(rocinante_web_libraries SYSTEM PUBLIC ${libraries}/include)
target_compile_definitions(rocinante_web_libraries PRIVATE SPNG_STATIC ZSTD_DISABLE_ASM)
target_compile_options(rocinante_web_libraries PRIVATE -O3 -w)

function(rocinante_web_sources folder)
  list(TRANSFORM ARGN PREPEND ${folder}/)
  list(TRANSFORM ARGN APPEND .cpp)
  target_sources(rocinante-viewer PRIVATE ${ARGN})
endfunction()

add_executable(rocinante-viewer)
rocinante_web_sources(core/base reader_notice hash duration_text plain_text name_hint figure_text pattern number_list
  version json_parse)
rocinante_web_sources(core/math angle_reduction srgb trigonometry transform)
rocinante_web_sources(core/packet packet text_name text_number header_reader statement_reader
  signal_reader fold_signal
  packet_text_decoder packet_text_writer state_folder fold_statement state_forgetting session_state
  item_text joint_order restatement)
rocinante_web_sources(core/mcap append_record byte_sink chunk_expander chunk_head no_lz4_frame open_chunk
  parse_record record_probe records record_stepper summary tail_reserve torn_chunk)
rocinante_web_sources(core/log other_format captured_range chunk_indexes clock_message damage_text file_order
  foreign_file growing_index import_record last_message log_end log_index log_index_summary log_index_walk log_profile
  log_reader log_types loss_message mapped_file message_span octets_before recorded_losses settled_walk span_cache
  span_damage span_merge)
rocinante_web_sources(core/session keyframe keyframe_finder log_fold log_pieces marks message_folder
  moment_walk session_time state_cache state_damage timeline)
rocinante_web_sources(core/report json_text)
rocinante_web_sources(core/series derived_value placed_links positional_names series_key series_scan series_store signal_series stated_values value_bins)
rocinante_web_sources(core/mesh mesh mesh_builder polygon shapes smooth_normals)
rocinante_web_sources(core/kinematics model joint_values kinematics mesh_scale)
rocinante_web_sources(core/cell cell cell_names device_appearance layer_index posed_lookup posed_scene view_path)
rocinante_web_sources(core/bundle baked_file)
rocinante_web_sources(viewer/bake bake_cell baked_guard)
rocinante_web_sources(viewer/picture exif_orientation mipmaps picture picture_options plain_png png whole_png stored_png lfs_pointer)
rocinante_web_sources(viewer/detail detail_builder detail_cache detail_file detail_level governor mesh_detail)
rocinante_web_sources(viewer/gl frame_buffer gl_table renderer_key shader_program)
rocinante_web_sources(viewer/view camera camera_choice depth_reach frame_extras hand_joints inset_layout known_names
  link_looks measure_style missing_meshes movable_devices render_style scene_poser
  trail_finder units view_choice)
rocinante_web_sources(viewer/cull coplanar_items coplanar_surfaces cull_sphere draw_list flat_faces
  scene_catalog translucent_order)
rocinante_web_sources(viewer/overlay embedded_font inspection_marks label_layout overlay overlay_panel
  scale_bar session_drawings text_atlas)
rocinante_web_sources(viewer/passes backdrop_pass background_pass caster_draw contact_map contact_shaders draw_passes draw_triangles
  edge_pass ghost_pass grid_pass identity_pass item_batch item_matrices look_shaders mesh_buffers
  mesh_edges outline_pass overlay_buffer overlay_pass plain_shader scene_pass shader_source
  shadow_fit shadow_map texture_store)
rocinante_web_sources(viewer/render fitted_cameras frame_maker identity_frame inset_frame
  renderer renderer_light renderer_numbers scaled_view source_rates stage_times)
rocinante_web_sources(viewer/model link_poses)
rocinante_web_sources(viewer/shown joint_rows plot_scale plot_shape signal_rows turntable value_text)
rocinante_web_sources(viewer/web web_context web_fold web_live web_main web_plots web_session)
rocinante_web_sources(viewer/web/port not_in_a_page)

target_include_directories(rocinante-viewer PRIVATE ${PROJECT_SOURCE_DIR} viewer/web/port)
target_compile_features(rocinante-viewer PRIVATE cxx_std_20)
target_compile_definitions(rocinante-viewer PRIVATE FMT_HEADER_ONLY SPNG_STATIC XXH_INLINE_ALL
  crc32_combine64=crc32_combine
  ROCINANTE_FONT_FILE="${ROCINANTE_FONT_FILE}"
  ROCINANTE_VERSION="rocinante ${PROJECT_VERSION}")
target_compile_options(rocinante-viewer PRIVATE -O3 -ffp-contract=off -Wall -Wextra
  -include ${PROJECT_SOURCE_DIR}/viewer/web/port/std_gaps.h
  $<$<BOOL:${ROCINANTE_WERROR}>:-Werror>)
target_link_libraries(rocinante-viewer PRIVATE rocinante_web_libraries)
target_link_options(rocinante-viewer PRIVATE -O3 -sENVIRONMENT=web -sMODULARIZE=1
  -sEXPORT_NAME=rocinanteViewer -sMIN_WEBGL_VERSION=2 -sMAX_WEBGL_VERSION=2 -sALLOW_MEMORY_GROWTH=1
  -sINITIAL_MEMORY=64MB -sMAXIMUM_MEMORY=2GB -sTOTAL_STACK=2MB -sASSERTIONS=0
  -sGL_ASSERTIONS=0 -sEXPORTED_FUNCTIONS=_malloc,_free -sEXPORTED_RUNTIME_METHODS=UTF8ToString,stringToUTF8,lengthBytesUTF8
  -sINCOMING_MODULE_JS_API=instantiateWasm,wasmBinary,canvas,print,printErr,onAbort)
# Starting the compiler is most of what a small file costs. Files whose local names clash with
# those of others are compiled alone.
set_target_properties(rocinante-viewer PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/bin
  UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 20)
set_source_files_properties(core/cell/device_appearance.cpp core/mesh/mesh.cpp core/mesh/mesh_builder.cpp
  core/mesh/polygon.cpp core/mesh/shapes.cpp core/mesh/smooth_normals.cpp
  core/base/duration_text.cpp viewer/web/web_context.cpp viewer/web/web_main.cpp
  viewer/web/port/not_in_a_page.cpp viewer/picture/plain_png.cpp viewer/picture/whole_png.cpp viewer/picture/stored_png.cpp
  PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
