// SPDX-License-Identifier: MIT
#include "homolog/shape/read_3mf.h"

#include <fmt/format.h>

#include "shape/files.h"
#include "shape/meshes.h"
#include "shape/zip_files.h"

namespace homolog {
namespace {

using Read3mf = FileTest;

std::string with(std::string text, const std::string& old, const std::string& other) {
  return text.replace(text.find(old), old.size(), other);
}

TEST_F(Read3mf, PutsObjectsOfSeveralPartsTogether) {
  EXPECT_EQ(read("a.3mf", zip::threemf(zip::model())).triangles.size(), 4u);
  const Mesh mesh = read("a.3mf", zip::threemf(zip::assembly(), zip::model()));
  EXPECT_EQ(mesh.triangles.size(), 8u);
  EXPECT_NEAR(meshes::volume(mesh), 2 * 8 / 6.0, 1e-12);
  // x goes to 2y, y to -2x, z to 2z + 1, after the second one is moved by 5
  EXPECT_EQ(bounding_box(mesh).min, Vec3(-2, 0, 1));
  EXPECT_EQ(bounding_box(mesh).max, Vec3(0, 12, 3));
}

TEST_F(Read3mf, LeavesOutWhatIsNotPrinted) {
  const std::string support = R"(<object id="7" type="support"><mesh><vertices/></mesh></object>)";
  const std::string both = R"(<item objectid="7"/><item objectid="1"/>)";
  EXPECT_EQ(read("a.3mf", zip::threemf(zip::model(support, both))).triangles.size(), 4u);
  expect_error("a.3mf", zip::threemf(zip::model(support, R"(<item objectid="7"/>)")), "no triangles");
  const std::string twice = R"(<item objectid="1" printable="1"/><item objectid="1" printable="0" transform="1 0 0 0 1 0 0 0 1 9 9 9"/>)";
  EXPECT_EQ(bounding_box(read("a.3mf", zip::threemf(zip::model("", twice)))).max,
            bounding_box(read("b.3mf", zip::threemf(zip::model()))).max);
  expect_error("a.3mf", zip::threemf(zip::model("", R"(<item objectid="1" printable="0"/>)")), "none of its objects is to be built");
}

TEST_F(Read3mf, LeavesOutWhatASlicerCallsNoPartOfTheSolid) {
  const auto parts = [](const std::string& volumes) {
    return zip::threemf(zip::model(), "", "<config><object id=\"1\">" + volumes + "</object></config>");
  };
  const auto volume = [](int first, int last, const std::string& key, const std::string& value) {
    return fmt::format(R"(<volume firstid="{}" lastid="{}"><metadata type="volume" key="{}" value="{}"/></volume>)", first, last, key,
                       value);
  };
  const std::string solid = volume(0, 1, "volume_type", "ModelPart");
  EXPECT_EQ(read("a.3mf", parts(solid + volume(2, 3, "volume_type", "ModelPart"))).triangles.size(), 4u);
  EXPECT_EQ(read("a.3mf", parts(solid + volume(2, 3, "volume_type", "ParameterModifier"))).triangles.size(), 2u);
  EXPECT_EQ(read("a.3mf", parts(solid + volume(3, 3, "modifier", "1"))).triangles.size(), 3u);
  expect_error("a.3mf", parts(volume(2, 4, "volume_type", "SupportBlocker")), "its slicer's parts do not fit its triangles");
  expect_error("a.3mf", parts(volume(-1, 3, "volume_type", "SupportBlocker")), "a triangle's number is below 0");
}

TEST_F(Read3mf, RefusesExtensionsThatItDoesNotKnow) {
  const auto requiring = [](const std::string& name) {
    return zip::threemf(with(zip::model(), "<model", "<model xmlns:q=\"" + name + "\" requiredextensions=\"q\""));
  };
  const std::string known = "http://schemas.microsoft.com/3dmanufacturing/";
  EXPECT_EQ(read("a.3mf", requiring(known + "production/2015/06")).triangles.size(), 4u);
  EXPECT_EQ(read("a.3mf", requiring(known + "material/2015/02")).triangles.size(), 4u);
  const std::string lattice = known + "beamlattice/2017/02";
  expect_error("a.3mf", requiring(lattice), "it needs the extension '" + lattice + "', which is not read; export it without");
  expect_error("a.3mf", zip::threemf(with(zip::model(), "<model", "<model requiredextensions=\"z\"")), "it needs the extension 'z'");
}

TEST_F(Read3mf, TellsThatBeamsAreLeftOut) {
  const std::string beams = R"(</triangles><b:beamlattice xmlns:b="b"><b:beams><b:beam v1="0" v2="1"/></b:beams></b:beamlattice>)";
  EXPECT_EQ(told("a.3mf", zip::threemf(zip::model())), "");
  EXPECT_EQ(told("a.3mf", zip::threemf(with(zip::model(), "</triangles>", beams))),
            "its beams (beamlattice) are left out; make triangles of them and export it again\n");
  const std::string elsewhere = R"(<object id="7"><mesh><vertices/><beamlattice><beam v1="0" v2="1"/></beamlattice></mesh></object>)";
  EXPECT_EQ(told("a.3mf", zip::threemf(zip::model(elsewhere))), "") << "an object that is not built";
}

TEST_F(Read3mf, NamesWhatItIsPackedBy) {
  std::string bytes = zip::threemf(zip::model());
  const auto pack_by = [&](char method) {
    for (std::size_t at = bytes.find("PK\3\4"); at != bytes.npos; at = bytes.find("PK\3\4", at + 1)) bytes[at + 8] = method;
    for (std::size_t at = bytes.find("PK\1\2"); at != bytes.npos; at = bytes.find("PK\1\2", at + 1)) bytes[at + 10] = method;
  };
  pack_by(14);
  expect_error("a.3mf", bytes, "is packed by LZMA, which is not read; unpack the archive and pack it again as zip does by default");
  pack_by(12);
  expect_error("a.3mf", bytes, "is packed by bzip2, which is not read");
}

TEST_F(Read3mf, IsKnownByWhatIsInIt) { EXPECT_EQ(read("a.zip", zip::threemf(zip::model())).triangles.size(), 4u); }

TEST_F(Read3mf, TellsThatNothingIsBuilt) {
  expect_error("a.3mf", zip::threemf(with(zip::model(), R"(<item objectid="1"/>)", "")), "none of its objects is to be built");
}

TEST_F(Read3mf, RefusesWhatIsMissingOrDamaged) {
  const std::string model = zip::model(), whole = zip::threemf(model);
  expect_error("a.3mf", "PK", "archive cannot be opened");
  expect_error("a.3mf", whole.substr(0, whole.size() - 30), "archive cannot be opened");
  expect_error("a.3mf", zip::archive({{"a.txt", "a"}}), "not of a 3MF model");
  expect_error("a.3mf", zip::archive({{"_rels/.rels", "<Relationships/>"}}), "names no 3D model");
  expect_error("a.3mf", with(whole, "y=\"1\"", "y=\"2\""), "cannot be unpacked");  // the check sum
  expect_error("a.3mf", zip::threemf(zip::model("", R"(<item p:path="/b.model" objectid="1"/>)")), "part 'b.model' is missing");
  expect_error("a.3mf", zip::threemf(zip::model("", R"(<item objectid="2"/>)")), "object '2' does not exist");
  expect_error("a.3mf", zip::threemf(with(model, "v1=\"0\"", "v1=\"4\"")), "vertex 4 does not exist (the object has 4");
  expect_error("a.3mf", zip::threemf(with(model, "x=\"1\"", "x=\"nan\"")), "'nan' is not a finite number");
  expect_error("a.3mf", zip::threemf(with(model, "x=\"1\"", "w=\"1\"")), "a vertex coordinate is missing");
  expect_error("a.3mf", zip::threemf(with(model, "</model>", "")), "truncated or damaged");
}

TEST_F(Read3mf, EndsWhereObjectsHoldThemselvesOrEachOtherTooOften) {
  const std::string circle = R"(<object id="2"><components><component objectid="2"/></components></object>)";
  expect_error("a.3mf", zip::threemf(zip::model(circle, R"(<item objectid="2"/>)")), "hold each other too often");
  std::string doubling;
  for (int i = 2; i < 60; ++i) {
    const std::string inner = std::to_string(i + 1);
    doubling += "<object id=\"" + std::to_string(i) + "\"><components><component objectid=\"" + inner + "\"/><component objectid=\"" +
                inner + "\"/></components></object>";
  }
  doubling += R"(<object id="60"/>)";
  expect_error("a.3mf", zip::threemf(zip::model(doubling, R"(<item objectid="2"/>)")), "hold each other too often");
}

TEST_F(Read3mf, UnpacksNoMoreThanTheLimit) {
  ReadLimits limits;
  limits.bytes = 300;
  const std::string whole = zip::threemf(zip::model());
  EXPECT_THROW(read_3mf(whole, "a.3mf", limits), FileError);
  limits = {};
  limits.triangles = 3;
  EXPECT_THROW(read_3mf(whole, "a.3mf", limits), FileError);
}

}  // namespace
}  // namespace homolog
