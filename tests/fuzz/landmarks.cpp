// SPDX-License-Identifier: MIT
// Landmark files beside CSV and .mrk.json; what was read is written and read again, and must be the same places.
#include "fuzz/target.h"
#include "homolog/outputs/landmark_editor.h"
#include "homolog/outputs/morphologika.h"
#include "homolog/outputs/read_fcsv.h"
#include "homolog/outputs/tps.h"

namespace homolog::fuzz {
namespace {

void require_finite(const std::vector<MarkupPoint>& points) {
  for (const MarkupPoint& point : points) require(!point.position || point.position->allFinite(), "coordinates are finite");
}

void require_same(const std::vector<MarkupPoint>& points, const std::vector<MarkupPoint>& again) {
  require(again.size() == points.size(), "as many points are read as were written");
  for (std::size_t i = 0; i < points.size(); ++i) require(points[i].position == again[i].position, "a point is read as it was written");
}

void run_fcsv(const std::string& bytes) {
  try {
    require_finite(read_fcsv(bytes, "fuzzed"));
  } catch (const FileError& error) {
    require_one_line(error);
  }
}

void run_pts(const std::string& bytes) {
  std::vector<MarkupPoint> points;
  try {
    points = read_pts(bytes, "fuzzed");
  } catch (const FileError& error) {
    return require_one_line(error);
  }
  require_finite(points);
  require_same(points, read_pts(pts_text(points), "written"));
}

/// `Read` and `Write` of a format that holds several specimens.
template <class Read, class Write>
void run_specimens(const std::string& bytes, const Read& read, const Write& write) {
  std::vector<Specimen> specimens;
  try {
    specimens = read(bytes, "fuzzed");
  } catch (const FileError& error) {
    return require_one_line(error);
  }
  for (const Specimen& specimen : specimens) {
    require_finite(specimen.points);
    const std::vector<Specimen> again = read(write(specimen), "written");
    if (!again.empty()) require_same(specimen.points, again[0].points);
  }
}

}  // namespace

Target fcsv() {
  return {"fcsv",
          {"# Markups fiducial file version = 4.11\n# CoordinateSystem = LPS\n# columns = "
           "id,x,y,z,ow,ox,oy,oz,vis,sel,lock,label,desc,associatedNodeID\n1,-1.5,2,3e1,0,0,0,1,1,1,0,\"a, "
           "b\",,\n2,0,0,0,0,0,0,1,1,1,0,c,,,0,0\n",
           "# CoordinateSystem = 0\nvtk_1,1,2,3\r\n\r\n#\n", "1,2,3,4\n", "# CoordinateSystem = IJK\n"},
          run_fcsv};
}

Target pts() {
  return {"pts", {"Version 1.0\n3\nS000 1 -2.5 3e-4\nS001 9999 9999 9999\nC000 0 0 0\n", "Version 1.0\r\n0\r\n", "Version\n-1\n"}, run_pts};
}

Target tps() {
  return {"tps",
          {"LM3=3\n1 2 3\nNA NA NA\n-4.5 0 1e3\nCURVES=1\nPOINTS=2\n1 1 1\n2 2 2\nIMAGE=a.jpg\nID=a\nSCALE=0.5\n", "lm=1\n1 2\n",
           "LM=1\r\n1 2 3\r\nCOMMENT=x\r\nLM3=1\r\n4 5 6\r\nOUTLINES=1\r\nPOINTS=1\r\n7 7\r\nID=b\r\n"},
          [](const std::string& bytes) { run_specimens(bytes, read_tps, tps_text); }};
}

Target morphologika() {
  return {
      "morphologika",
      {"[individuals]\n2\n[landmarks]\n2\n[dimensions]\n3\n[names]\na\nb\n[rawpoints]\n'a\n1 2 3\nNA NA NA\n'b\n-4 5e1 6\n9999 9999 9999\n",
       "[Individuals]\r\n0\r\n[landmarks]\r\n0\r\n[dimensions]\r\n3\r\n[rawpoints]\r\n[wireframe]\r\n1 2\r\n",
       "[individuals]\n\"x\n1\n[landmarks]\n",
       "[individuals]\n1\n[landmarks]\n1\n[dimensions]\n3\n[names]\n\x1e[names]\n[rawpoints]\n1 2 3\n"},
      [](const std::string& bytes) { run_specimens(bytes, read_morphologika, morphologika_text); }};
}

}  // namespace homolog::fuzz
