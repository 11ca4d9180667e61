#include <gtest/gtest.h>

#include "tests/core/cell/cell_fixture.h"

namespace rocinante {
namespace {

class CellFaults : public test::CellFolder {};

TEST_F(CellFaults, KeysThatTheFormatHasNotAreErrorsWithAGuess) {
  EXPECT_EQ(faultsOf(R"(format = 1
serach = ["models"]
x-mine = 1
[[device]]
name = "a"
model = "arm.urdf"
colour = "#ffffff"
x-mine = { any = "thing" }
pose = { xyz = [0, 0, 0], rpy_degrees = [0, 0, 0] }
[[camera]]
name = "c"
eye = [1, 0, 0]
target = [0, 0, 0]
fov = 45
)"),
            "test.cell.toml:2:1: error: the cell has an unknown key `serach` (did you mean "
            "`search`?) [cell.unknown-key]\n"
            "test.cell.toml:7:1: error: [[device]] has an unknown key `colour` (did you mean "
            "`color`?) [cell.unknown-key]\n"
            "test.cell.toml:9:27: error: pose has an unknown key `rpy_degrees` (its keys are "
            "quaternion, rpy, rpy_deg, xyz) [cell.unknown-key]\n"
            "test.cell.toml:14:1: error: [[camera]] has an unknown key `fov` (did you mean "
            "`fov_deg`?) [cell.unknown-key]\n");
}

struct CellFaultCase {
  const char* text;
  const char* fault;
};

TEST_F(CellFaults, EachKindOfFaultSaysWhereAndWhat) {
  const std::string head = "format = 1\n";
  const CellFaultCase cases[] = {
      {"[[device]]\nname = 'a'\n",
       "test.cell.toml:2:1: error: [[device]] lacks `model` [cell.missing-key]\n"},
      {"[[device]]\nname = 'a/b'\nmodel = 'arm.urdf'\n",
       "test.cell.toml:3:8: error: `a/b` is not a valid name (names have at most 255 bytes and no "
       "slash) [cell.bad-name]\n"},
      {"[[device]]\nname = 'a'\nmodel = 'amr.urdf'\n",
       "test.cell.toml:4:9: error: the model `amr.urdf` is not used: there is no such file within "
       "the search roots (add its folder to `search` in the cell, or use --search) "
       "[cell.missing-file]\n"},
      {"[[device]]\nname = 'a'\nmodel = '../../../../../../../../etc/passwd.urdf'\n",
       "test.cell.toml:4:9: error: the model `../../../../../../../../etc/passwd.urdf` is not "
       "used: there is no such file within the search roots (add its folder to `search` in the "
       "cell, or use --search) [cell.missing-file]\n"},
      {"[[device]]\nname = 'a'\nmodel = 'tank.obj'\n",
       "test.cell.toml:4:9: error: no model is named `tank.obj` (write a [[model]] with its name, "
       "unit and up axis, and use that) [cell.unknown-model]\n"},
      {"[[device]]\nname = 'a'\nmodel = 'arm.urdf'\n[[device]]\nname = 'a'\nmodel = 'arm.urdf'\n",
       "test.cell.toml:6:8: error: a second [[device]] is named `a` (the first one is used) "
       "[cell.duplicate-name]\n"},
      {"[[device]]\nname = 'a'\nmodel = 'arm.urdf'\noptional = 'yes'\ncolor = 'red'\n",
       "test.cell.toml:5:12: error: `optional` of [[device]] is a string, where true or false is "
       "expected [cell.wrong-kind]\n"
       "test.cell.toml:6:9: error: `red` is not a colour (colours are \"#rrggbb\" or "
       "\"#rrggbbaa\") "
       "[cell.bad-color]\n"},
      {"[[device]]\nname = 'a'\nmodel = 'arm.urdf'\n"
       "pose = { xyz = [1, 2], rpy = [0, 0, inf], quaternion = [0, 0, 0, 0] }\n",
       "test.cell.toml:5:8: error: pose has more than one of rpy, rpy_deg and quaternion "
       "[cell.two-orientations]\n"
       "test.cell.toml:5:16: error: `xyz` of pose must be 3 finite numbers [cell.bad-number]\n"
       "test.cell.toml:5:30: error: `rpy` of pose must be 3 finite numbers [cell.bad-number]\n"
       "test.cell.toml:5:56: error: the quaternion is zero (the identity rotation is [0, 0, 0, 1]: "
       "x y z w) [cell.zero-quaternion]\n"},
      {"[[device]]\nname = 'a'\nmodel = 'arm.urdf'\non = 'b/tip'\n"
       "[[device]]\nname = 'b'\nmodel = 'arm.urdf'\non = 'a/tpi'\n",
       "test.cell.toml:9:6: error: device `a` has no link `tpi` (did you mean `tip`?) "
       "[cell.unknown-link]\n"},
      {"[[device]]\nname = 'a'\nmodel = 'arm.urdf'\non = 'b'\n"
       "[[device]]\nname = 'b'\nmodel = 'arm.urdf'\non = 'a'\n",
       "test.cell.toml:5:6: error: device `a` carries itself, directly or through others (all "
       "devices of the loop are placed in the world) [cell.carrier-loop]\n"},
      {"search = ['none', '/']\n",
       "test.cell.toml:2:10: error: the search root does not exist: `none` [cell.bad-root]\n"
       "test.cell.toml:2:10: error: the whole file system cannot be a search root "
       "[cell.bad-root]\n"},
      {"device = 3\n",
       "test.cell.toml:2:10: error: `device` of the cell must be tables (write [[device]]) "
       "[cell.wrong-kind]\n"},
      {"[[model]]\nname = 't'\nobj = 'tank.obj'\n",
       "test.cell.toml:2:1: error: [[model]] lacks `unit` (OBJ and STL files state none: \"m\", "
       "\"cm\", \"mm\", \"in\", \"ft\", or metres) [cell.missing-key]\n"
       "test.cell.toml:2:1: error: [[model]] lacks `up` (OBJ and STL do not say which axis points "
       "up: \"y\" or \"z\") [cell.missing-key]\n"},
      {"[[model]]\nname = 't'\nobj = 'tank.obj'\nunit = 'yard'\nup = 'x'\ngeometry = 'wrld'\n",
       "test.cell.toml:5:8: error: `yard` is not a unit (units are \"m\", \"cm\", \"mm\", \"in\", "
       "\"ft\", or a number of metres) [cell.unknown-word]\n"
       "test.cell.toml:6:6: error: `x` is not an up axis (\"y\" or \"z\") [cell.unknown-word]\n"
       "test.cell.toml:7:12: error: `wrld` is not a kind of geometry (\"world\" (as assembled at "
       "zero joints) or \"link\" (each in its link's space)) [cell.unknown-word]\n"},
      {"[[model]]\nname = 't'\n",
       "test.cell.toml:2:1: error: [[model]] names no file (give one of `obj`, `stl`, `mesh` "
       "and `urdf`) "
       "[cell.model-kind]\n"},
      {"[[camera]]\nname = 'c'\neye = [0, 0, 1]\ntarget = [0, 0, 1]\n",
       "test.cell.toml:5:10: error: `eye` and `target` are the same point [cell.no-direction]\n"},
      {"[[camera]]\nname = 'c'\neye = [0, 0, 1]\ntarget = [0, 0, 0]\nfov_deg = 180\non = 'arm'\n",
       "test.cell.toml:6:11: error: `fov_deg` must be between 0 and 180 [cell.bad-number]\n"
       "test.cell.toml:7:6: error: `on` of [[camera]] names `arm`, which is not a device of the "
       "cell [cell.unknown-device]\n"},
      {"[[camera]]\nname = 'c'\neye = [0, 0, 1]\ntarget = [0, 0, 0]\nfov_deg = 40\n"
       "intrinsics = { fx = 0, fy = 800, cx = 320, width = 640.5, height = 480 }\n"
       "distortion = [0.1, 0.2]\n",
       "test.cell.toml:7:14: error: intrinsics lacks `cy` [cell.missing-key]\n"
       "test.cell.toml:7:14: error: the camera has both intrinsics and fov_deg or ortho_height_m "
       "[cell.two-projections]\n"
       "test.cell.toml:7:21: error: `fx` of intrinsics must be 1 to 1000000 pixels "
       "[cell.bad-number]\n"
       "test.cell.toml:7:52: error: `width` of intrinsics must be a whole number up to 16384 "
       "[cell.bad-number]\n"
       "test.cell.toml:8:14: error: `distortion` must be the numbers k1, k2, p1, p2 and, if there "
       "is one, k3 [cell.bad-number]\n"},
      {"[[source]]\nname = 's'\nrate_hz = [70, 50]\ndevices = ['a', 3]\nghost_of = { p = 'b' }\n",
       "test.cell.toml:4:11: error: `rate_hz` of [[source]] is [lowest, highest], but 70 is above "
       "50 [cell.bad-range]\n"
       "test.cell.toml:5:11: warning: `devices` of [[source]] names `a`, which the cell does not "
       "have "
       "[cell.unknown-device]\n"
       "test.cell.toml:5:17: error: `devices` of [[source]] holds an integer, where strings are "
       "expected [cell.wrong-kind]\n"
       "test.cell.toml:6:18: error: `p` should be a ghost of `b`, which is not a device of the "
       "cell [cell.unknown-device]\n"},
      {"[[signal]]\npath = '-'\nname = 't'\nunit = '\u00B0C'\nrate = [1, 2]\n"
       "[[signal]]\npath = '-'\nname = 'u'\nunit = '\u20AC'\n",
       "test.cell.toml:5:8: error: `\u00B0C` is not 1 to 32 printable ASCII characters without "
       "spaces and quotes (did you mean `degC`?) [cell.bad-name]\n"
       "test.cell.toml:6:1: error: [[signal]] has an unknown key `rate` (did you mean `rate_hz`?) "
       "[cell.unknown-key]\n"
       "test.cell.toml:10:8: error: `\u20AC` is not 1 to 32 printable ASCII characters without "
       "spaces and quotes (such as degC, N.m or m/s2) [cell.bad-name]\n"},
      {"[scene]\nlight = [0, 0, 0]\ngrid_step_m = 0\ngrid_size_m = 1e9\n",
       "test.cell.toml:3:9: error: `light` has no direction [cell.no-direction]\n"
       "test.cell.toml:4:15: error: `grid_step_m` must be above 0 [cell.bad-number]\n"
       "test.cell.toml:4:15: error: the grid has more than 1,000 lines to each side (the step is "
       "enlarged) [cell.bad-number]\n"},
      {"[[layer]]\nname = 'robots'\n[[device]]\nname = 'a'\nmodel = 'arm.urdf'\nlayer = 'robot'\n",
       "test.cell.toml:7:9: warning: no [[layer]] is named `robot` (did you mean `robots`?) "
       "[cell.unknown-layer]\n"},
  };
  for (const CellFaultCase& each : cases) {
    SCOPED_TRACE(each.text);
    EXPECT_EQ(faultsOf(head + each.text), each.fault);
  }
}

TEST_F(CellFaults, KeysNestedSoDeepThatReadingThemWouldOverrunTheStackAreRefused) {
  std::string deep = "a";
  for (int i = 0; i < 100'000; ++i) deep += " . 'b.c'";
  const std::string refused = "REFUSED: a key has more than 17 parts (test.cell.toml:3:";
  EXPECT_EQ(faultsOf("format = 1\n# a.b\n[x-" + deep + "]\n"), refused + "134)");
  EXPECT_EQ(faultsOf("format = 1\n\nx-" + deep + " = 1\n"), refused + "133)");
  EXPECT_EQ(faultsOf("format = 1\n\nx-a = { " + deep + " = 1 }\n"), refused + "139)");
  EXPECT_EQ(faultsOf("format = 1\nx-a = " + std::string(100, '[')),
            "REFUSED: values are nested deeper than 64 (test.cell.toml:2:71)");
  // Dots in numbers, strings and comments are not keys.
  std::string dots, numbers;
  for (int i = 0; i < 100; ++i) {
    dots += "a.";
    numbers += " 1.5,";
  }
  EXPECT_EQ(faultsOf("format = 1 # " + dots + "\nx-a = \"\\\"" + dots + "\"\nx-b = [" + numbers +
                     "]\nx-c = '''\n'" + dots + "'''\nx-d = \"\"\"\n" + dots + "\"\"\"\n"),
            "");
  // Letters beyond ASCII there are not keys either, also after quotes that end a long string.
  EXPECT_EQ(faultsOf("format = 1 # \xC3\xA9\nx-a = [\"\"\"\xC3\xA9\"\"\"\"\", '\xC3\xA9']\n"), "");
}

TEST_F(CellFaults, LinksOverGroupsAreHeldToTheFile) {
  const std::string head =
      "format = 1\n[[model]]\nname = 'g'\nobj = 'gantry.obj'\nunit = 'm'\nup = 'z'\n";
  const CellFaultCase cases[] = {
      {"[[model.link]]\nname = 'a'\nparent = 'base'\ngroups = ['brigde_left', 'hand']\n"
       "joint = { name = 'x', type = 'prismatc', axis = [1, 0, 0] }\n",
       "test.cell.toml:10:10: error: no group of the file is `brigde_left` (did you mean "
       "`bridge_left`?) [cell.unknown-group]\n"
       "test.cell.toml:11:30: error: `prismatc` is not a joint type (did you mean `prismatic`?) "
       "[cell.unknown-word]\n"},
      {"[[model.link]]\nname = 'a'\nparent = 'bsae'\n"
       "joint = { name = 'x', type = 'revolute' }\n",
       "test.cell.toml:8:8: error: link `a` has no parent joint, and neither has `base` (connect "
       "it with a joint; it is drawn at the model's origin) [cell.two-roots]\n"
       "test.cell.toml:9:10: error: the parent of joint `x` is `bsae`, which is not a link (did "
       "you mean `base`?) [cell.unknown-link]\n"
       "test.cell.toml:10:9: error: joint lacks `axis` [cell.missing-key]\n"},
      {"[[model.link]]\nname = 'root'\ngroups = ['frame', 'bridge*']\n"
       "[[model.link]]\nname = 'b'\nparent = 'root'\ngroups = ['*_left']\n"
       "joint = { name = 'x', type = 'fixed', limits = [0, 1] }\n",
       "test.cell.toml:2:1: warning: no link takes group `trolley`, which is not drawn (add it to "
       "the `groups` of a link, or leave them out of the root, which then takes all) "
       "[cell.unused-group]\n"
       "test.cell.toml:13:10: error: group `bridge_left` belongs to links `root` and `b` (the "
       "first one keeps it) [cell.group-taken-twice]\n"
       "test.cell.toml:14:48: error: a fixed joint has no limits [cell.useless-limits]\n"},
      {"[[model.link]]\nname = 'a'\nparent = 'base'\n",
       "test.cell.toml:7:1: error: [[model.link]] `a` has a parent but no `joint` (joint = { name "
       "= \"...\", type = \"fixed\" } holds it in place) [cell.missing-key]\n"
       "test.cell.toml:8:8: error: link `a` has no parent joint, and neither has `base` (connect "
       "it with a joint; it is drawn at the model's origin) [cell.two-roots]\n"},
  };
  for (const CellFaultCase& each : cases) {
    SCOPED_TRACE(each.text);
    EXPECT_EQ(faultsOf(head + each.text), each.fault);
  }
}

}  // namespace
}  // namespace rocinante
