// SPDX-License-Identifier: MIT
// PCL's tutorial way: SHOT at evenly thinned points, nearest partners, geometric consistency.
//   pcl_shot MODEL DATA   (text files of x y z nx ny nz) prints {"matrix": 4 x 4} of the largest cluster, or nothing.
#include <pcl/common/common.h>
#include <pcl/features/shot_omp.h>
#include <pcl/filters/uniform_sampling.h>
#include <pcl/kdtree/kdtree_flann.h>
#include <pcl/point_types.h>
#include <pcl/recognition/cg/geometric_consistency.h>

#include <algorithm>
#include <cstdio>
#include <fstream>

namespace {

using Points = pcl::PointCloud<pcl::PointXYZ>;
using Normals = pcl::PointCloud<pcl::Normal>;
using Descriptors = pcl::PointCloud<pcl::SHOT352>;

struct Cloud {
  Points::Ptr points{new Points}, keypoints{new Points};
  Normals::Ptr normals{new Normals};
  Descriptors::Ptr descriptors{new Descriptors};
};

Cloud read(const char* path) {
  Cloud cloud;
  std::ifstream file(path);
  pcl::PointXYZ p;
  float nx, ny, nz;
  while (file >> p.x >> p.y >> p.z >> nx >> ny >> nz) {
    cloud.points->push_back(p);
    cloud.normals->push_back(pcl::Normal(nx, ny, nz));
  }
  return cloud;
}

void describe(Cloud& cloud, double size) {
  pcl::UniformSampling<pcl::PointXYZ> thin;
  thin.setInputCloud(cloud.points);
  thin.setRadiusSearch(0.02 * size);
  thin.filter(*cloud.keypoints);
  pcl::SHOTEstimationOMP<pcl::PointXYZ, pcl::Normal, pcl::SHOT352> shot(1);
  shot.setRadiusSearch(0.075 * size);
  shot.setInputCloud(cloud.keypoints);
  shot.setInputNormals(cloud.normals);
  shot.setSearchSurface(cloud.points);
  shot.compute(*cloud.descriptors);
}

pcl::CorrespondencesPtr nearest_partners(const Cloud& model, const Cloud& data) {
  pcl::KdTreeFLANN<pcl::SHOT352> tree;
  tree.setInputCloud(model.descriptors);
  pcl::CorrespondencesPtr pairs(new pcl::Correspondences);
  for (std::size_t i = 0; i < data.descriptors->size(); ++i) {
    const auto& descriptor = (*data.descriptors)[i];
    pcl::Indices nearest(1);
    std::vector<float> distance(1);
    if (!std::isfinite(descriptor.descriptor[0]) || tree.nearestKSearch(descriptor, 1, nearest, distance) != 1) continue;
    if (distance[0] < 0.25f) pairs->emplace_back(nearest[0], static_cast<int>(i), distance[0]);
  }
  return pairs;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) return 2;
  Cloud model = read(argv[1]), data = read(argv[2]);
  pcl::PointXYZ low, high;
  pcl::getMinMax3D(*data.points, low, high);
  const double size = (high.getVector3fMap() - low.getVector3fMap()).norm();
  describe(model, size);
  describe(data, size);
  pcl::GeometricConsistencyGrouping<pcl::PointXYZ, pcl::PointXYZ> grouping;
  grouping.setGCSize(0.02 * size);
  grouping.setGCThreshold(8);
  grouping.setInputCloud(model.keypoints);
  grouping.setSceneCloud(data.keypoints);
  grouping.setModelSceneCorrespondences(nearest_partners(model, data));
  std::vector<Eigen::Matrix4f, Eigen::aligned_allocator<Eigen::Matrix4f>> found;
  std::vector<pcl::Correspondences> clusters;
  grouping.recognize(found, clusters);
  if (clusters.empty()) return 0;  // nothing printed is nothing found
  std::size_t best = 0;
  for (std::size_t i = 1; i < clusters.size(); ++i) best = clusters[i].size() > clusters[best].size() ? i : best;
  std::printf("{\"matrix\": [");
  for (int i = 0; i < 4; ++i) {
    const auto row = found[best].row(i);
    std::printf("%s[%g, %g, %g, %g]", i ? ", " : "", row[0], row[1], row[2], row[3]);
  }
  std::printf("]}\n");
}
