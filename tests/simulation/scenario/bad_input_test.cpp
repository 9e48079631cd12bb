#include <string>

#include "scenario_text.h"

namespace fissure::bad_input_test {

namespace {

struct BadCase {
  const char* name;
  const char* from;      ///< text of the full scenario below that is replaced ...
  const char* to;        ///< ... by this
  const char* expected;  ///< start of the message
};

void PrintTo(const BadCase& bad, std::ostream* out) {
  *out << bad.name;
}

const std::string full_text =
    "format: 1\n"                                                    // 1
    "name: full\n"                                                   // 2
    "description: some text\n"                                       // 3
    "time: {step_s: 0.001, settle_s: 0.1, duration_s: 1}\n"          // 4
    "world: {gravity_m_s2: [0, -9.81, 0]}\n"                         // 5
    "ground: {height_m: 0, friction: 0.5}\n"                         // 6
    "bodies:\n"                                                      // 7
    "  - name: ball\n"                                               // 8
    "    shape: {type: sphere, radius_m: 0.03, subdivisions: 2}\n"   // 9
    "    position_m: [0, 0.03, 0]\n"                                 // 10
    "    orientation: [0, 0, 0, 1]\n"                                // 11
    "    mass_kg: 0.1\n"                                             // 12
    "    pose_frame: true\n"                                         // 13
    "    solver: {damping: 0.01, position_iterations: 10}\n"         // 14
    "tools:\n"                                                       // 15
    "  - name: blade\n"                                              // 16
    "    shape: {type: box, size_m: [0.04, 0.002, 0.015]}\n"         // 17
    "    motion:\n"                                                  // 18
    "      type: script\n"                                           // 19
    "      start_m: [0, 0.1, 0]\n"                                   // 20
    "      segments:\n"                                              // 21
    "        - {move_to_m: [0, 0.05, 0], speed_m_s: 0.1}\n"          // 22
    "        - {hold_s: 0.1}\n"                                      // 23
    "pipelines:\n"                                                   // 24
    "  - {pipeline: default, settings: tuned}\n"                     // 25
    "  - {name: full, pipeline: fukuhara, sweeps: 10}\n"             // 26
    "force:\n"                                                       // 27
    "  - {name: hc, model: hunt_crossley, k: 200, lambda: 50}\n"     // 28
    "  - {name: linear, model: linear_elastic, k: 200}\n"            // 29
    "record: {snapshots_every_s: 0.01, frames: {every_s: 0.05}}\n";  // 30

std::string caseName(const testing::TestParamInfo<BadCase>& bad) {
  return bad.param.name;
}

class BadInput : public testing::TestWithParam<BadCase> {};

TEST_P(BadInput, IsOneLineWithFileAndLine) {
  const BadCase& bad = GetParam();
  std::string text = full_text;
  const std::size_t at = text.find(bad.from);
  ASSERT_NE(at, std::string::npos);
  text.replace(at, std::string(bad.from).size(), bad.to);
  const std::string message = inputError([&] { parseScenario(text, "a.yaml"); });
  EXPECT_EQ(message.substr(0, std::string(bad.expected).size()), bad.expected) << message;
  EXPECT_EQ(message.find('\n'), std::string::npos);
}

const BadCase yaml_cases[] = {
    {"DuplicateKey", "    mass_kg: 0.1\n", "    mass_kg: 0.1\n    mass_kg: 0.2\n",
     "a.yaml:13: duplicate key \"mass_kg\", first written in line 12, expected it once"},
    {"DuplicateKeyInFlowMap", "height_m: 0,", "height_m: 0, height_m: 0,",
     "a.yaml:6: duplicate key \"height_m\""},
    {"Tab", "    mass_kg", "\tmass_kg", "a.yaml:12: a tab in the indentation, expected spaces"},
    {"Anchor", "mass_kg: 0.1", "mass_kg: &m 0.1", "a.yaml:12: an anchor or alias"},
    {"AnchorOnMap", "ground: {", "ground: &g {", "a.yaml:6: an anchor or alias"},
    {"Alias", "mass_kg: 0.1", "mass_kg: *m", "a.yaml:12: "},
    {"Tag", "mass_kg: 0.1", "mass_kg: !!float 0.1", "a.yaml:12: a tag (tag:yaml.org,2002:float)"},
    {"UnclosedFlowMap", "height_m: 0, friction: 0.5}", "height_m: 0, friction: 0.5", "a.yaml:"},
    {"TextAfterQuote", "name: full\n", "name: \"full\" more\n", "a.yaml:2: "},
    {"SecondDocument", "record:", "---\nrecord:", "a.yaml:30: a second document, expected a single one"},
    {"KeyIsAList", "record:", "[1, 2]: 3\nrecord:", "a.yaml:30: a key that is not a word"},
    {"KeyIsNull", "record:", "~: 3\nrecord:", "a.yaml:30: a key that is not a word"},
    {"NotUtf8", "some text", "some \xff text", "a.yaml:3: binary data or not UTF-8, expected UTF-8 text"},
    {"OverlongUtf8", "some text", "some \xc0\xaf text", "a.yaml:3: binary data or not UTF-8"},
    {"ControlCharacter", "some text", "some \x1b text", "a.yaml:3: binary data or not UTF-8"},
};
INSTANTIATE_TEST_SUITE_P(Yaml, BadInput, testing::ValuesIn(yaml_cases), caseName);

const BadCase key_cases[] = {
    {"UnknownKey", "subdivisions: 2", "subdivision: 2",
     "a.yaml:9: unknown key \"subdivision\" in bodies.ball.shape, did you mean \"subdivisions\"?"},
    {"UnitForgotten", "mass_kg: 0.1", "mass: 0.1",
     "a.yaml:12: unknown key \"mass\" in bodies.ball, did you mean \"mass_kg\"?"},
    {"UnknownKeyFarFromAll", "height_m: 0,", "colour_of_it: 0,",
     "a.yaml:6: unknown key \"colour_of_it\" in ground, expected one of height_m, friction, hardness"},
    {"ExpectationWithoutAQuantity",
     "record:", "expect:\n  - {max: 1}\nrecord:", "a.yaml:31: missing key \"quantity\""},
    {"MisspeltRequiredKey", "radius_m", "raduis_m",
     "a.yaml:9: unknown key \"raduis_m\" in bodies.ball.shape, did you mean \"radius_m\"?"},
    {"KeyOfAnotherShape", "subdivisions: 2", "size_m: [1, 1, 1]",
     "a.yaml:9: unknown key \"size_m\" in bodies.ball.shape, expected one of type, radius_m, subdivisions"},
    {"MissingKey", "radius_m: 0.03, ", "",
     "a.yaml:9: missing key \"radius_m\" in bodies.ball.shape, expected it"},
    {"MissingType", "type: box, ", "", "a.yaml:17: missing key \"type\" in tools.blade.shape, expected it"},
    {"MissingName", "  - name: ball\n    shape", "  - shape", "a.yaml:8: missing key \"name\" in bodies.0"},
    {"MissingMotionType", "      type: script\n", "",
     "a.yaml:18: missing key \"type\" in tools.blade.motion, expected it"},
    {"MissingModel", "model: linear_elastic, ", "", "a.yaml:29: missing key \"model\" in force.linear"},
    {"MissingPipeline", "{pipeline: default, settings: tuned}", "{settings: tuned}",
     "a.yaml:25: missing key \"pipeline\" in pipelines.0, expected it"},
    {"MissingFormat", "format: 1\n", "", "a.yaml:1: missing key \"format\", expected it"},
    {"LambdaForLinearElastic", "linear_elastic, k: 200", "linear_elastic, k: 200, lambda: 50",
     "a.yaml:29: key \"lambda\" in force.linear has no meaning here, expected it only for model "
     "hunt_crossley"},
    {"RateForLinearElastic", "linear_elastic, k: 200", "linear_elastic, k: 200, rate: velocities",
     "a.yaml:29: key \"rate\" in force.linear has no meaning here, expected it only for models "
     "hunt_crossley, kelvin_voigt and exponential"},
    {"DampingForHuntCrossley", "lambda: 50", "c: 50",
     "a.yaml:28: key \"c\" in force.hc has no meaning here, expected it only for models kelvin_voigt and "
     "exponential"},
    {"PerAreaWithoutCoefficient", "lambda: 50", "per_area: true",
     "a.yaml:28: missing key \"lambda\" in force.hc, expected it"},
    {"SweepsForDefault", "settings: tuned", "sweeps: 10",
     "a.yaml:25: key \"sweeps\" in pipelines.default has no meaning here"},
    {"SettingsForFukuhara", "sweeps: 10", "settings: tuned",
     "a.yaml:26: key \"settings\" in pipelines.full has no meaning here"},
    {"RampForConstantTiming", "speed_m_s: 0.1", "speed_m_s: 0.1, ramp_fraction: 0.1",
     "a.yaml:22: key \"ramp_fraction\" in tools.blade.motion.segments.0 has no meaning here"},
    {"TimingForHold", "hold_s: 0.1", "hold_s: 0.1, timing: constant",
     "a.yaml:23: key \"timing\" in tools.blade.motion.segments.1 has no meaning here"},
};

const BadCase type_cases[] = {
    {"TextForNumber", "step_s: 0.001", "step_s: fast",
     "a.yaml:4: time.step_s is \"fast\", expected a number"},
    {"QuotedNumber", "step_s: 0.001", "step_s: \"0.001\"",
     "a.yaml:4: time.step_s is the text \"0.001\", expected a number"},
    {"NumberWithUnit", "mass_kg: 0.1", "mass_kg: 0.1 kg",
     "a.yaml:12: bodies.ball.mass_kg is \"0.1 kg\", expected a number"},
    {"DecimalComma", "mass_kg: 0.1", "mass_kg: 0,1",
     "a.yaml:12: bodies.ball.mass_kg is \"0,1\", expected a number"},
    {"Hexadecimal", "mass_kg: 0.1", "mass_kg: 0x1",
     "a.yaml:12: bodies.ball.mass_kg is \"0x1\", expected a number"},
    {"ListForNumber", "mass_kg: 0.1", "mass_kg: [0.1]",
     "a.yaml:12: bodies.ball.mass_kg is a list, expected a number"},
    {"NothingForNumber", "mass_kg: 0.1",
     "mass_kg:", "a.yaml:12: bodies.ball.mass_kg is empty, expected a number"},
    {"Octal", "position_iterations: 10", "position_iterations: 010",
     "a.yaml:14: bodies.ball.solver.position_iterations is \"010\", expected a whole number without a "
     "leading zero"},
    {"OctalReal", "mass_kg: 0.1", "mass_kg: 00.1",
     "a.yaml:12: bodies.ball.mass_kg is \"00.1\", expected a number without"},
    {"NaN", "mass_kg: 0.1", "mass_kg: .nan",
     "a.yaml:12: bodies.ball.mass_kg is \".nan\", expected a finite number"},
    {"Infinity", "mass_kg: 0.1", "mass_kg: -.inf",
     "a.yaml:12: bodies.ball.mass_kg is \"-.inf\", expected a finite number"},
    {"BareNaN", "mass_kg: 0.1", "mass_kg: NaN",
     "a.yaml:12: bodies.ball.mass_kg is \"NaN\", expected a finite number"},
    {"NaNInVector", "[0, 0.03, 0]", "[0, .nan, 0]",
     "a.yaml:10: bodies.ball.position_m.1 is \".nan\", expected a finite"},
    {"TooLarge", "mass_kg: 0.1", "mass_kg: 1e999",
     "a.yaml:12: bodies.ball.mass_kg is \"1e999\", expected a number that a double can hold"},
    {"RealForCount", "subdivisions: 2", "subdivisions: 2.0",
     "a.yaml:9: bodies.ball.shape.subdivisions is \"2.0\", expected a whole number"},
    {"HugeCount", "subdivisions: 2", "subdivisions: 99999999999",
     "a.yaml:9: bodies.ball.shape.subdivisions is \"99999999999\", expected a whole number of"},
    {"YesForTruth", "pose_frame: true", "pose_frame: yes",
     "a.yaml:13: bodies.ball.pose_frame is \"yes\", expected true or false"},
    {"OneForTruth", "pose_frame: true", "pose_frame: 1",
     "a.yaml:13: bodies.ball.pose_frame is \"1\", expected true or false"},
    {"NumberForText", "name: full\n", "name: 12\n", "a.yaml:2: name is \"12\", expected a text"},
    {"TruthForText", "name: full\n", "name: true\n", "a.yaml:2: name is \"true\", expected a text"},
    {"EmptyText", "name: full\n", "name: \"\"\n",
     "a.yaml:2: name is the text \"\", expected at least one letter"},
    {"LineEndInText", "some text", "\"two\\nlines\"",
     "a.yaml:3: description is the text \"two lines\", expected one line"},
    {"ShortVector", "[0, 0.03, 0]", "[0, 0.03]",
     "a.yaml:10: bodies.ball.position_m has 2 items, expected a list of 3"},
    {"NumberForVector", "[0, 0.03, 0]", "0.03",
     "a.yaml:10: bodies.ball.position_m is \"0.03\", expected a list of 3"},
    {"LongQuaternion", "[0, 0, 0, 1]", "[0, 0, 0, 1, 0]", "a.yaml:11: bodies.ball.orientation has 5 items"},
    {"NotAUnitQuaternion", "[0, 0, 0, 1]", "[0, 0, 1, 1]",
     "a.yaml:11: bodies.ball.orientation has length 1.4142135623730951, expected a unit quaternion [x, y, z, "
     "w]"},
    {"ZeroQuaternion", "[0, 0, 0, 1]", "[0, 0, 0, 0]",
     "a.yaml:11: bodies.ball.orientation has length 0, expected a unit"},
    {"NumberForMap", "ground: {height_m: 0, friction: 0.5}", "ground: 0",
     "a.yaml:6: ground is \"0\", expected a map"},
    {"EmptyMap", "ground: {height_m: 0, friction: 0.5}",
     "ground:", "a.yaml:6: ground is empty, expected a map ({} for"},
    {"MapForList",
     "  - {name: hc, model: hunt_crossley, k: 200, lambda: 50}\n  - {name: linear, model: linear_elastic, k: "
     "200}\n",
     "  hc: {model: hunt_crossley}\n", "a.yaml:27: force is a map, expected a list"},
    {"TextForItem", "  - {name: linear, model: linear_elastic, k: 200}", "  - linear",
     "a.yaml:29: force.1 is \"linear\", expected a map"},
    {"UnknownShape", "type: sphere", "type: shpere",
     "a.yaml:9: bodies.ball.shape.type is \"shpere\", did you mean \"sphere\"?"},
    {"UnknownToolShape", "type: box", "type: bax",
     "a.yaml:17: tools.blade.shape.type is \"bax\", did you mean \"box\"?"},
    {"UnknownPipeline", "pipeline: fukuhara", "pipeline: fukuhra",
     "a.yaml:26: pipelines.full.pipeline is \"fukuhra\", did you mean \"fukuhara\"?"},
    {"PipelineNull", "pipeline: fukuhara", "pipeline: null",
     "a.yaml:26: pipelines.full.pipeline is empty, expected a name (in quotes if it is \"null\""},
    {"UnknownModel", "linear_elastic", "cubic",
     "a.yaml:29: force.linear.model is \"cubic\", expected one of hunt_crossley, kelvin_voigt, "
     "linear_elastic"},
    {"UnknownPrecision", "{name: full, pipeline: fukuhara", "{name: full, pipeline: fukuhara, precision: f16",
     "a.yaml:26: pipelines.full.precision is \"f16\", expected one of f64, f32"},
    {"UnknownSettings", "{name: full, pipeline: fukuhara, sweeps: 10}", "{pipeline: cluster, settings: best}",
     "a.yaml:26: pipelines.cluster.settings is \"best\", expected one of stock, tuned"},
    {"UnknownResponse", "{name: full, pipeline: fukuhara",
     "{name: full, pipeline: fukuhara, response: momentun",
     "a.yaml:26: pipelines.full.response is \"momentun\", did you mean \"momentum\"?"},
    {"UnknownSoftContact", "pose_frame: true", "soft_contact: vertex",
     "a.yaml:13: bodies.ball.soft_contact is \"vertex\", expected one of none, vertices, clusters"},
    {"UnknownAeroModel", "damping: 0.01", "aero_model: V_Pointed",
     "a.yaml:14: bodies.ball.solver.aero_model is \"V_Pointed\", did you mean \"V_Point\"?"},
    {"UnknownPlacement", "0.015]}", "0.015]}\n    nodes: {placement: gird}",
     "a.yaml:18: tools.blade.nodes.placement is \"gird\", did you mean \"grid\"?"},
    {"UnknownTiming", "speed_m_s: 0.1", "speed_m_s: 0.1, timing: minimal_jerk",
     "a.yaml:22: tools.blade.motion.segments.0.timing is \"minimal_jerk\", did you mean \"minimum_jerk\"?"},
    {"NewerFormat", "format: 1", "format: 2\nnew_key: 1", "a.yaml:1: format is 2, expected 1"},
};

const BadCase value_cases[] = {
    {"NegativeSize", "[0.04, 0.002, 0.015]", "[0.04, -0.002, 0.015]",
     "a.yaml:17: tools.blade.shape.size_m is [0.04, -0.002, 0.015], expected three numbers above 0"},
    {"ZeroDuration", "duration_s: 1", "duration_s: 0",
     "a.yaml:4: time.duration_s is 0, expected a number above 0"},
    {"StepBeyondDuration", "step_s: 0.001", "step_s: 2",
     "a.yaml:4: time.step_s is 2, expected at most the duration, 1 s"},
    {"AbsurdSubdivisions", "subdivisions: 2", "subdivisions: 40",
     "a.yaml:9: bodies.ball.shape.subdivisions is 40, expected a number from 0 to 7"},
    {"ValueLeftToItsDefault", "time: {step_s: 0.001, settle_s: 0.1, duration_s: 1}",
     "time: {duration_s: 1e-4}", "a.yaml:4: time.step_s is 0.001, expected at most the duration, 1e-04 s"},
    {"BadSegment", "{hold_s: 0.1}", "{hold_s: 0.1, move_to_m: [0, 0, 0]}",
     "a.yaml:23: tools.blade.motion.segments.1 holds and moves"},
    {"DuplicateName", "name: linear", "name: hc",
     "a.yaml:29: force.1.name is \"hc\" again, expected each name once"},
    {"DuplicateDefaultName", "{name: full, pipeline: fukuhara, sweeps: 10}", "{pipeline: default}",
     "a.yaml:26: pipelines.1.name is \"default\" again, expected each name once"},
    {"BadName", "name: ball", "name: the ball",
     "a.yaml:8: bodies.0.name is \"the ball\", expected 1 to 64 letters"},
};

INSTANTIATE_TEST_SUITE_P(Keys, BadInput, testing::ValuesIn(key_cases), caseName);
INSTANTIATE_TEST_SUITE_P(Types, BadInput, testing::ValuesIn(type_cases), caseName);
INSTANTIATE_TEST_SUITE_P(Values, BadInput, testing::ValuesIn(value_cases), caseName);

TEST(BadInputBase, TheFullScenarioItselfIsGood) {
  EXPECT_EQ(inputError([] { parseScenario(full_text, "a.yaml"); }), "nothing");
}

TEST(BadInputBase, LinesAreRightWithWindowsLineEndsAndAByteOrderMark) {
  std::string text = "\xef\xbb\xbf";
  for (const char c : full_text) text += c == '\n' ? std::string("\r\n") : std::string(1, c);
  EXPECT_EQ(inputError([&] { parseScenario(text, "a.yaml"); }), "nothing");
  text.replace(text.find("mass_kg"), 7, "mass_gk");
  EXPECT_EQ(inputError([&] { parseScenario(text, "a.yaml"); }),
            "a.yaml:12: unknown key \"mass_gk\" in bodies.ball, did you mean \"mass_kg\"?");
}

TEST(BadInputBase, DeepNestingIsAnErrorNotACrash) {
  for (const char bracket : {'[', '{'}) {
    EXPECT_EQ(inputError([&] { parseScenario(std::string(100000, bracket), "a.yaml"); }),
              "a.yaml:1: nested too deeply, expected a scenario");
  }
}

TEST(BadInputBase, AQuoteThatIsNeverClosedDoesNotSwallowTheRest) {
  const std::string text = std::string(smallest_text) + "description: \"a line of text\nmeasure: {}\n\n";
  const std::string message = inputError([&] { parseScenario(text, "a.yaml"); });
  EXPECT_EQ(message, "a.yaml:10: column 12: a text in quotes is not closed, expected its second quote");
}

TEST(BadInputBase, DocumentMarksAroundTheOneDocumentAreFine) {
  EXPECT_EQ(inputError([] { parseScenario(std::string("---\n") + smallest_text + "...\n", "a.yaml"); }),
            "nothing");
}

class BadFile : public ScenarioFiles {};

TEST_F(BadFile, MissingFile) {
  EXPECT_EQ(loadError("none.yaml"), "none.yaml: no such file, expected a text file");
}

TEST_F(BadFile, Folder) {
  std::filesystem::create_directories(folder_ / "sub");
  EXPECT_EQ(loadError("sub"), "sub: is a folder, expected a text file");
}

TEST_F(BadFile, Empty) {
  write("a.yaml", "");
  EXPECT_EQ(loadError("a.yaml"), "a.yaml: has size 0, expected a text file");
  write("b.yaml", "# only a comment\n\n");
  EXPECT_EQ(loadError("b.yaml"), "b.yaml:1: empty, expected a scenario");
}

TEST_F(BadFile, Binary) {
  write("a.yaml", std::string("\x89HDF\r\n\x1a\n\0\0", 10));
  EXPECT_EQ(loadError("a.yaml"),
            "a.yaml: is an HDF5 file, as results are, expected YAML; type: fissure info a.yaml");
}

TEST_F(BadFile, NotAMap) {
  write("a.yaml", "# a list\n- 1\n- 2\n");
  EXPECT_EQ(loadError("a.yaml"), "a.yaml:2: not a map, expected `key: value` lines");
}

TEST_F(BadFile, LogThatAReplayNamesIsMissing) {
  write("a.yaml", std::string(smallest_text) +
                      "tools:\n"
                      "  - name: blade\n"
                      "    shape: {type: box, size_m: [1, 1, 1]}\n"
                      "    motion:\n"
                      "      type: replay\n"
                      "      file: hand.csv\n"
                      "      rate_hz: 1000\n");
  EXPECT_EQ(loadError("a.yaml"),
            "a.yaml:14: tools.blade.motion.file is \"hand.csv\": no such file, expected a log");
  EXPECT_EQ(loadError("a.yaml", {{"tools.blade.motion.file", "/dev/zero"}}),
            "--set tools.blade.motion.file: tools.blade.motion.file is \"/dev/zero\": is no regular file, "
            "expected a log");
  const std::filesystem::path log = write("hand.csv", "x,y,z\n0,0,0\n");
  const LoadedScenario loaded = loadScenario(folder_ / "a.yaml");
  EXPECT_EQ(loaded.inputs, (std::vector<std::filesystem::path>{folder_ / "a.yaml", log}));
}

TEST_F(BadFile, MeshThatABodyNames) {
  const auto text = [](const std::string& shape) {
    return "format: 1\nname: a\ntime: {duration_s: 1}\nbodies:\n  - name: organ\n    shape: {type: file" +
           shape + "}\npipelines: [{pipeline: fukuhara}]\n";
  };
  write("a.yaml", text(", file: organ.stl"));
  EXPECT_EQ(loadError("a.yaml"), "a.yaml:6: missing key \"unit\" in bodies.organ.shape, expected it");
  write("a.yaml", text(", file: organ.stl, unit: inch"));
  EXPECT_NE(loadError("a.yaml").find("a.yaml:6: bodies.organ.shape.unit is \"inch\""), std::string::npos)
      << loadError("a.yaml");
  write("a.yaml", text(", file: organ.stl, unit: mm, repairs: [orient, cap_hole]"));
  EXPECT_EQ(loadError("a.yaml"),
            "a.yaml:6: bodies.organ.shape.repairs.1 is \"cap_hole\", did you mean \"cap_holes\"?");
  write("a.yaml", text(", file: organ.stl, unit: mm, repairs: [orient, cap_holes]"));
  EXPECT_EQ(loadError("a.yaml"),
            "a.yaml:6: bodies.organ.shape.file is \"organ.stl\": no such file, expected a mesh");
  write("b.yaml", text(", file: ., unit: mm"));
  EXPECT_EQ(loadError("b.yaml"), "b.yaml:6: bodies.organ.shape.file is \".\": is a folder, expected a mesh");
  const std::filesystem::path mesh = write("organ.stl", "solid");
  const LoadedScenario loaded = loadScenario(folder_ / "a.yaml");
  EXPECT_EQ(loaded.inputs, (std::vector<std::filesystem::path>{folder_ / "a.yaml", mesh}));
  FileShape shape;
  shape.file = "organ.stl";
  shape.unit = LengthUnit::mm;
  shape.repairs = {MeshRepair::orient, MeshRepair::cap_holes};
  EXPECT_EQ(std::get<FileShape>(loaded.scenario.bodies[0].shape), shape);
  EXPECT_EQ(parseScenario(loaded.resolved, folder_ / "a.yaml").scenario, loaded.scenario);
  // In a folder above, named by a base there.
  std::filesystem::create_directory(folder_ / "below");
  write("below/b.yaml", "base: ../a.yaml\nname: b\n");
  EXPECT_EQ(std::get<FileShape>(loadScenario(folder_ / "below/b.yaml").scenario.bodies[0].shape).file,
            "../organ.stl");
}

}  // namespace

}  // namespace fissure::bad_input_test
