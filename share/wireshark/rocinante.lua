-- A dissector of Rocinante's packet text (docs/packet-format.md) for Wireshark and tshark.
-- Use: tshark -X lua_script:rocinante.lua -r session.pcap, or copy it into Wireshark's folder of
-- plugins. It knows packets by their first bytes, on any UDP port, and has fields of what it shows:
-- rocinante.source, rocinante.sequence, rocinante.statement ...

local packet_text = Proto("rocinante", "Rocinante packet text")

local fields = {
  source = ProtoField.string("rocinante.source", "Source"),
  run = ProtoField.string("rocinante.run", "Run"),
  sequence = ProtoField.uint64("rocinante.sequence", "Sequence"),
  time = ProtoField.absolute_time("rocinante.time", "Time"),
  word = ProtoField.string("rocinante.word", "Word"),
  restated = ProtoField.bool("rocinante.restated", "Restated"),
  statement = ProtoField.string("rocinante.statement", "Statement"),
  kind = ProtoField.string("rocinante.kind", "Kind"),
  device = ProtoField.string("rocinante.device", "Device"),
  link = ProtoField.string("rocinante.link", "Link"),
  signal = ProtoField.string("rocinante.signal", "Signal"),
  unit = ProtoField.string("rocinante.unit", "Unit"),
  truth = ProtoField.bool("rocinante.truth", "Truth"),
  value = ProtoField.double("rocinante.value", "Value"),
  text = ProtoField.string("rocinante.text", "Text"),
}
for _, field in pairs(fields) do table.insert(packet_text.fields, field) end

local malformed = ProtoExpert.new("rocinante.malformed", "Malformed header",
  expert.group.MALFORMED, expert.severity.WARN)
packet_text.experts = { malformed }

-- Statements whose first field is a device.
local of_device = { joints = true, order = true, joint = true, pose = true, add = true,
  remove = true, seen = true }

local truths = { ["true"] = true, ["false"] = false }

-- %XX as in URLs.
local function decoded(name)
  return (name:gsub("%%(%x%x)", function(digits) return string.char(tonumber(digits, 16)) end))
end

-- Calls use(field, offset from 0) for each field of a line: runs without spaces and tabs.
local function each_field(line, use)
  for start, field in line:gmatch("()([^ \t]+)") do use(field, start - 1) end
end

local function show_header(line, range, tree)
  local words = {}
  each_field(line, function(field, at) table.insert(words, { field, range(at, #field) }) end)
  if #words < 4 then
    tree:add_proto_expert_info(malformed)
    return ""
  end
  local source, run = words[2][1]:match("^([^@]*)@?(.*)$")
  tree:add(fields.source, words[2][2], decoded(source))
  if run ~= "" then tree:add(fields.run, words[2][2], decoded(run)) end
  if words[3][1]:match("^%d+$") then
    tree:add(fields.sequence, words[3][2], UInt64(words[3][1]))
  end
  local seconds, fraction = words[4][1]:match("^(%d+)%.?(%d*)$")
  if seconds then
    local nanoseconds = tonumber((fraction .. "000000000"):sub(1, 9))
    tree:add(fields.time, words[4][2], NSTime.new(tonumber(seconds), nanoseconds))
  end
  for i = 5, #words do
    tree:add(fields.word, words[i][2], words[i][1])
    if words[i][1] == "restated" then tree:add(fields.restated, words[i][2], true) end
  end
  return decoded(source) .. " " .. words[3][1]
end

-- The PATH of a signal: DEVICE, DEVICE/LINK, or "-" for neither.
local function show_path(path, place, branch)
  if path == "-" then return end
  local device, link = path:match("^([^/]*)/?(.*)$")
  branch:add(fields.device, place, decoded(device))
  if link ~= "" then branch:add(fields.link, place, decoded(link)) end
end

local function show_value(value, place, branch)
  if truths[value] ~= nil then
    branch:add(fields.truth, place, truths[value])
  elseif tonumber(value) then
    branch:add(fields.value, place, tonumber(value))
  end
end

-- NAME VALUE [UNIT] of `signal`, whose texts in quotes are shown as those of other statements:
-- what follows a number is a unit, and in a text with blanks a word. True when it shows a number.
local function show_signal(number, field, place, branch, is_number)
  if number == 3 then
    branch:add(fields.signal, place, decoded(field))
  elseif number == 4 then
    show_value(field, place, branch)
    return tonumber(field) ~= nil
  elseif number == 5 and is_number then
    branch:add(fields.unit, place, field)
  end
  return false
end

local function show_statement(line, range, tree)
  local branch = tree:add(fields.statement, range, line)
  local number = 0
  local kind
  local is_number = false
  each_field(line, function(field, at)
    number = number + 1
    local place = range(at, #field)
    if number == 1 then
      kind = field
      branch:add(fields.kind, place, field)
    elseif number == 2 and of_device[kind] then
      branch:add(fields.device, place, decoded(field))
    elseif number == 2 and (kind == "signal" or kind == "signals") then
      show_path(field, place, branch)
    elseif kind == "signal" then
      is_number = show_signal(number, field, place, branch, is_number)
    elseif kind == "signals" and field:match("=") then
      local name, value = field:match("^(.-)=(.*)$")
      branch:add(fields.signal, place, decoded(name))
      show_value(value, place, branch)
    elseif (kind == "joints" or kind == "pose") and tonumber(field) then
      branch:add(fields.value, place, tonumber(field))
    elseif kind == "joint" and field:match("=") then
      local value = tonumber(field:match("=(.*)$"))
      if value then branch:add(fields.value, place, value) end
    end
  end)
  local from, text = line:match('()(".*")')
  if from then branch:add(fields.text, range(from - 1, #text), text) end
  return kind
end

function packet_text.dissector(buffer, pinfo, root)
  local whole = buffer():raw()
  if whole:sub(1, 3) ~= "RK1" and not whole:match("\nRK1[ \t]") then return 0 end
  pinfo.cols.protocol = "RK1"
  local tree = root:add(packet_text, buffer(), "Rocinante packet text")
  local summary = {}
  local has_header = false
  -- Offsets are from 1, as in Lua; a line ends with LF, the last may lack it.
  for start, line in whole:gmatch("()([^\n]*)") do
    line = line:gsub("[\r%z]+$", "")
    if line:match("[^ \t]") and not line:match("^[ \t]*#") then
      local range = buffer(start - 1, #line)
      if has_header then
        table.insert(summary, show_statement(line, range, tree))
      else
        has_header = true
        table.insert(summary, show_header(line, range, tree))
      end
    end
  end
  pinfo.cols.info = table.concat(summary, " ")
  return buffer:len()
end

-- By content: senders choose their ports.
packet_text:register_heuristic("udp", function(buffer, pinfo, root)
  if buffer:len() < 4 or not buffer():raw():match("^[%s]*RK1[ \t]") then return false end
  return packet_text.dissector(buffer, pinfo, root) > 0
end)
