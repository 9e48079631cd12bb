#include <gtest/gtest.h>

#include <set>
#include <string>
#include <variant>

#include "scenario/catalog.h"
#include "scenario_text.h"
#include "text/did_you_mean.h"
#include "text/scalars.h"
#include "text/text_file.h"

namespace fissure::parts_test {

namespace {

TEST(Quotes, HoldWholeCharactersOfTheBeginning) {
  EXPECT_EQ(inQuotes("a\"b"), "\"a\"b\"");
  EXPECT_EQ(inQuotes("abcd", 4), "\"abcd\"");
  EXPECT_EQ(inQuotes("abcde", 4), "\"abcd...\"");
  EXPECT_EQ(inQuotes("abc\xc3\xa4", 4), "\"abc...\"");
  EXPECT_EQ(inQuotes("\x80\x80\x80", 2), "\"...\"");
}

TEST(EditDistance, CountsSingleEdits) {
  EXPECT_EQ(editDistance("", ""), 0);
  EXPECT_EQ(editDistance("", "abc"), 3);
  EXPECT_EQ(editDistance("abc", "abc"), 0);
  EXPECT_EQ(editDistance("abc", "abd"), 1);
  EXPECT_EQ(editDistance("abc", "ab"), 1);
  EXPECT_EQ(editDistance("abc", "acb"), 1);  // a swap of neighbours is one slip of the fingers
  EXPECT_EQ(editDistance("kitten", "sitting"), 3);
}

TEST(DidYouMean, SuggestsTheNearestOrListsAll) {
  EXPECT_EQ(didYouMean("frction", {"fraction_s", "friction"}), ", did you mean \"friction\"?");
  EXPECT_EQ(didYouMean("mass", {"margin_m", "mass_kg"}), ", did you mean \"mass_kg\"?");
  EXPECT_EQ(didYouMean("quite_else", {"a", "b"}), ", expected one of a, b");
  EXPECT_EQ(didYouMean("x", {}), ", expected none here");
  EXPECT_EQ(didYouMean("", {"ab"}), ", expected one of ab");
  EXPECT_EQ(didYouMean(std::string(100000, 'x'), {"ab"}), ", expected one of ab");
}

TEST(Scalars, KindsOfPlainScalars) {
  for (const char* text : {"0", "-12", "+7", "1234567890123"})
    EXPECT_EQ(scalarKind(text), ScalarKind::integer) << text;
  for (const char* text : {"0.5", ".5", "5.", "-1e-3", "1E5", "0e0", "1e+05", "0.0"}) {
    EXPECT_EQ(scalarKind(text), ScalarKind::real) << text;
  }
  for (const char* text : {"010", "00", "-01", "00.5", "01e3"}) {
    EXPECT_EQ(scalarKind(text), ScalarKind::leading_zero) << text;
  }
  for (const char* text : {".nan", ".inf", "-.Inf", "+.INF", "nan", "-inf", "Infinity"}) {
    EXPECT_EQ(scalarKind(text), ScalarKind::non_finite) << text;
  }
  for (const char* text : {"true", "false"}) EXPECT_EQ(scalarKind(text), ScalarKind::truth) << text;
  for (const char* text :
       {"", "x", "-", ".", "e5", "1e", "0x10", "1_000", "1 2", "1,5", "--1", "True", "infant"}) {
    EXPECT_EQ(scalarKind(text), ScalarKind::text) << text;
  }
}

TEST(Scalars, NumbersOutOfRangeHaveNoValue) {
  EXPECT_EQ(toReal("1e999"), std::nullopt);
  EXPECT_EQ(toReal("1e-999"), std::nullopt);
  EXPECT_EQ(toReal("+0.25"), 0.25);
  EXPECT_EQ(toReal("5."), 5.0);
  EXPECT_EQ(toInt("2147483647"), 2147483647);
  EXPECT_EQ(toInt("2147483648"), std::nullopt);
  EXPECT_EQ(toInt("+5"), 5);
}

TEST(Scalars, TextIsQuotedWhereItWouldReadAsSomethingElse) {
  for (const char* text : {"a", "some_name-2", "logs/hand.csv", "f64", "x"})
    EXPECT_EQ(formatText(text), text);
  for (const char* text : {"", "12", "true", "null", "-y", "a b", "a: b", "#", "1e5", "~", "inf", "nan"}) {
    EXPECT_EQ(formatText(text), '"' + std::string(text) + '"');
  }
  EXPECT_EQ(formatText("a\"b\\c\n\t"), "\"a\\\"b\\\\c\\n\\t\"");
}

TEST(TextFile, FindsTheFirstLineThatIsNoText) {
  EXPECT_EQ(firstLineNotText("plain\ttext\r\n\xc3\xbc \xe2\x82\xac \xf0\x9f\x98\x80\n"), 0);
  EXPECT_EQ(firstLineNotText(""), 0);
  EXPECT_EQ(firstLineNotText("a\nb\n\x01"), 3);
  EXPECT_EQ(firstLineNotText(std::string("a\0b", 3)), 1);
  for (const char* bad : {"\x80", "\xc3", "\xc3(", "\xc0\x80", "\xe0\x80\x80", "\xed\xa0\x80",
                          "\xf0\x80\x80\x80", "\xf4\x90\x80\x80", "\xf5\x80\x80\x80", "\xe2\x82", "\x7f"}) {
    EXPECT_EQ(firstLineNotText(std::string("a\n") + bad), 2) << bad;
  }
}

TEST(Names, LettersDigitsUnderscoresAndDashes) {
  for (const char* name : {"a", "A-1_b", "0"}) EXPECT_TRUE(isName(name)) << name;
  for (const char* name : {"", "a b", "a.b", "a/b", "\xc3\xa9"}) EXPECT_FALSE(isName(name)) << name;
}

TEST(CatalogTables, NamesAreUniqueAndDescribed) {
  const Catalog& c = catalog();
  for (const auto* table :
       {&c.pipelines,      &c.force_laws,      &c.tissues,       &c.body_shapes,    &c.tool_shapes,
        &c.clamp_openings, &c.node_placements, &c.motions,       &c.timings,        &c.interpolations,
        &c.settings,       &c.precisions,      &c.responses,     &c.length_units,   &c.rates,
        &c.deformations,   &c.aero_models,     &c.soft_contacts, &c.mesh_repairs,   &c.device_axes,
        &c.log_layouts,    &c.device_frames,   &c.time_units,    &c.ground_contacts}) {
    std::set<std::string_view> names;
    for (const CatalogEntry& entry : *table) {
      EXPECT_TRUE(isName(entry.name));
      EXPECT_TRUE(names.insert(entry.name).second) << entry.name;
      EXPECT_FALSE(entry.description.empty()) << entry.name;
    }
    EXPECT_FALSE(names.empty());
  }
}

/// Reading takes the index of a name for the value of an enum or the alternative of a variant.
TEST(CatalogTables, AreInTheOrderOfTheirTypes) {
  const Catalog& c = catalog();
  const auto at = [](const std::vector<CatalogEntry>& table, auto value) {
    return table.at(static_cast<std::size_t>(value)).name;
  };
  using Shapes = decltype(BodySettings::shape);
  ASSERT_EQ(c.body_shapes.size(), std::variant_size_v<Shapes>);
  EXPECT_EQ(at(c.body_shapes, Shapes(SphereShape{}).index()), "sphere");
  EXPECT_EQ(at(c.body_shapes, Shapes(BoxShape{}).index()), "box");
  EXPECT_EQ(at(c.body_shapes, Shapes(TrianglesShape{}).index()), "triangles");
  EXPECT_EQ(at(c.body_shapes, Shapes(FileShape{}).index()), "file");
  EXPECT_EQ(at(c.body_shapes, Shapes(CapsuleShape{}).index()), "capsule");
  EXPECT_EQ(at(c.body_shapes, Shapes(LobesShape{}).index()), "lobes");
  EXPECT_EQ(at(c.clamp_openings, ClampOpening::parallel), "parallel");
  EXPECT_EQ(at(c.clamp_openings, ClampOpening::hinged), "hinged");
  using Motions = decltype(ToolSettings::motion);
  ASSERT_EQ(c.motions.size(), std::variant_size_v<Motions>);
  EXPECT_EQ(at(c.motions, Motions(ScriptMotion{}).index()), "script");
  EXPECT_EQ(at(c.motions, Motions(ReplayMotion{}).index()), "replay");
  EXPECT_EQ(at(c.device_axes, DeviceAxis::x), "x");
  EXPECT_EQ(at(c.device_axes, DeviceAxis::z), "z");
  EXPECT_EQ(at(c.node_placements, NodePlacement::grid), "grid");
  EXPECT_EQ(at(c.node_placements, NodePlacement::centroids), "centroids");
  EXPECT_EQ(at(c.precisions, Precision::f64), "f64");
  EXPECT_EQ(at(c.precisions, Precision::f32), "f32");
  EXPECT_EQ(at(c.settings, SettingsPreset::stock), "stock");
  EXPECT_EQ(at(c.settings, SettingsPreset::tuned), "tuned");
  EXPECT_EQ(at(c.deformable_contacts, DeformableContacts::nodes), "nodes");
  EXPECT_EQ(at(c.deformable_contacts, DeformableContacts::faces), "faces");
  EXPECT_EQ(at(c.responses, ContactResponse::none), "none");
  EXPECT_EQ(at(c.responses, ContactResponse::momentum), "momentum");
  EXPECT_EQ(at(c.ground_contacts, GroundKind::bullet), "bullet");
  EXPECT_EQ(at(c.ground_contacts, GroundKind::half_space), "half_space");
  EXPECT_EQ(at(c.soft_contacts, SoftContact::none), "none");
  EXPECT_EQ(at(c.soft_contacts, SoftContact::vertices), "vertices");
  EXPECT_EQ(at(c.soft_contacts, SoftContact::clusters), "clusters");
  EXPECT_EQ(at(c.aero_models, AeroModel::V_Point), "V_Point");
  EXPECT_EQ(at(c.aero_models, AeroModel::V_TwoSided), "V_TwoSided");
  EXPECT_EQ(at(c.aero_models, AeroModel::V_TwoSidedLiftDrag), "V_TwoSidedLiftDrag");
  EXPECT_EQ(at(c.aero_models, AeroModel::V_OneSided), "V_OneSided");
  EXPECT_EQ(at(c.aero_models, AeroModel::F_TwoSided), "F_TwoSided");
  EXPECT_EQ(at(c.aero_models, AeroModel::F_TwoSidedLiftDrag), "F_TwoSidedLiftDrag");
  EXPECT_EQ(at(c.aero_models, AeroModel::F_OneSided), "F_OneSided");
  EXPECT_EQ(at(c.mesh_repairs, MeshRepair::drop_degenerate), "drop_degenerate");
  EXPECT_EQ(at(c.mesh_repairs, MeshRepair::drop_duplicate_faces), "drop_duplicate_faces");
  EXPECT_EQ(at(c.mesh_repairs, MeshRepair::keep_largest_shell), "keep_largest_shell");
  EXPECT_EQ(at(c.mesh_repairs, MeshRepair::drop_unreferenced), "drop_unreferenced");
  EXPECT_EQ(at(c.mesh_repairs, MeshRepair::orient), "orient");
  EXPECT_EQ(at(c.mesh_repairs, MeshRepair::cap_holes), "cap_holes");
  EXPECT_EQ(at(c.timings, Timing::constant), "constant");
  EXPECT_EQ(at(c.timings, Timing::trapezoidal), "trapezoidal");
  EXPECT_EQ(at(c.timings, Timing::minimum_jerk), "minimum_jerk");
  EXPECT_EQ(at(c.interpolations, Interpolation::linear), "linear");
  EXPECT_EQ(at(c.interpolations, Interpolation::monotone_cubic), "monotone_cubic");
  EXPECT_EQ(at(c.length_units, LengthUnit::m), "m");
  EXPECT_EQ(at(c.length_units, LengthUnit::mm), "mm");
  EXPECT_EQ(at(c.length_units, LengthUnit::cm), "cm");
  EXPECT_EQ(at(c.time_units, TimeUnit::s), "s");
  EXPECT_EQ(at(c.time_units, TimeUnit::ms), "ms");
  EXPECT_EQ(at(c.time_units, TimeUnit::us), "us");
  EXPECT_EQ(at(c.time_units, TimeUnit::ns), "ns");
}

TEST(CatalogTables, EveryPipelineAndLawCanBeWrittenInAFile) {
  for (const CatalogEntry& entry : catalog().pipelines) {
    const std::string quoted = '"' + std::string(entry.name) + '"';
    const Scenario s =
        parseScenario(smallest_text, "a.yaml",
                      {{"pipelines", "[{pipeline: " + quoted + "}]"},
                       {"bodies.ball.model", entry.name == "deformable" ? "elastic" : "shell"}})
            .scenario;
    EXPECT_EQ(s.pipelines.at(0).name, entry.name);
    EXPECT_EQ(s.pipelines.at(0).traits().name, entry.name);
  }
  for (const CatalogEntry& entry : catalog().force_laws) {
    const std::string law = "[{model: " + std::string(entry.name) + "}]";
    EXPECT_EQ(parseScenario(smallest_text, "a.yaml", {{"force", law}}).scenario.force.at(0).name, entry.name);
  }
}

TEST(PipelineSettingsValues, TunedAndStockMeanWhatTheTableSays) {
  PipelineSettings p;
  p.pipeline = PipelineKind::default_sdf;
  EXPECT_EQ(p.sdfVoxel_m(), 0.25);
  EXPECT_EQ(p.kinematicHardness(), 0.1);
  p.settings = SettingsPreset::tuned;
  EXPECT_EQ(p.sdfVoxel_m(), 0.0005);
  EXPECT_EQ(p.kinematicHardness(), 1.0);
  p.sdf_voxel_m = 0.01;
  EXPECT_EQ(p.sdfVoxel_m(), 0.01);
  EXPECT_FALSE(p.usesNodes());
  EXPECT_TRUE(p.usesSdf());
  for (const PipelineKind rays : {PipelineKind::raycast, PipelineKind::fukuhara}) {
    p.pipeline = rays;
    EXPECT_TRUE(p.usesNodes());
    EXPECT_FALSE(p.usesSdf());
  }
  p.pipeline = PipelineKind::swept;
  EXPECT_FALSE(p.usesNodes());
  EXPECT_TRUE(p.usesSurface());
  EXPECT_TRUE(p.hasFriction());
  p.pipeline = PipelineKind::prescribed;
  EXPECT_FALSE(p.usesSurface());
  EXPECT_FALSE(p.usesNodes());
  EXPECT_FALSE(p.usesSdf());
}

TEST(PipelineSettingsValues, BulletsDeformableWorldIsSetAsItsExamplesOfTheMaterialAre) {
  using enum ElasticMaterialKind;
  PipelineSettings p{.name = "p", .pipeline = PipelineKind::deformable};
  EXPECT_TRUE(p.usesVolume());
  EXPECT_FALSE(p.hasVoxels());
  EXPECT_EQ(p.contacts, DeformableContacts::faces);
  EXPECT_FALSE(*p.deformableSolver(neo_hookean).implicit);
  EXPECT_EQ(*p.deformableSolver(neo_hookean).contact_iterations, 150);
  EXPECT_EQ(*p.deformableSolver(neo_hookean).krylov_tolerance, 1e-8) << "of conjugate residuals";
  EXPECT_TRUE(*p.deformableSolver(linear_corotated).implicit);
  EXPECT_EQ(*p.deformableSolver(linear_corotated).contact_tolerance, 1e-3);
  EXPECT_LT(*p.deformableSolver(linear_corotated).krylov_tolerance, 1e-15) << "of conjugate gradients";
  p.settings = SettingsPreset::tuned;
  for (const ElasticMaterialKind material : {neo_hookean, linear_corotated})
    EXPECT_FALSE(*p.deformableSolver(material).implicit);
  p.deformable.contact_iterations = 3;
  p.contacts = DeformableContacts::nodes;
  EXPECT_TRUE(p.hasVoxels());
  p.fillDefaults(neo_hookean);
  EXPECT_EQ(p.deformable.contact_iterations, 3);
  EXPECT_EQ(p.deformable.projection, false) << "a stored scenario says it";
  EXPECT_EQ(p.deformable.substeps, std::nullopt) << "they follow the elements";
  EXPECT_EQ(p.sdf_voxel_m, 0.0005);
}

TEST(PipelineSettingsValues, TheFullMethodIsTrueToMomentumUnlessToldOtherwise) {
  PipelineSettings p;
  p.pipeline = PipelineKind::fukuhara;
  EXPECT_EQ(p.contactResponse(), ContactResponse::momentum);
  p.response = ContactResponse::none;
  EXPECT_EQ(p.contactResponse(), ContactResponse::none);
  p.response.reset();
  p.pipeline = PipelineKind::raycast;
  EXPECT_EQ(p.contactResponse(), ContactResponse::none);
  p.fillDefaults(ElasticMaterialKind::neo_hookean);
  EXPECT_EQ(p.response, ContactResponse::none) << "a stored scenario says it";
}

TEST(PipelineSettingsValues, NodesStandOnBulletsGroundUnlessToldOtherwise) {
  for (const PipelineTraits& pipeline : pipeline_table) {
    PipelineSettings p{.name = "p", .pipeline = pipeline.kind};
    EXPECT_EQ(p.ownGround(), pipeline.kind == PipelineKind::swept) << pipeline.name;
    p.ground_contact = GroundKind::half_space;
    EXPECT_TRUE(p.ownGround());
  }
}

}  // namespace

}  // namespace fissure::parts_test
