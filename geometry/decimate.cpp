#include "geometry/decimate.h"

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <OpenMesh/Tools/Decimater/DecimaterT.hh>
#include <OpenMesh/Tools/Decimater/ModQuadricT.hh>

namespace toile {

namespace {

struct Traits : OpenMesh::DefaultTraits {
  using Point = OpenMesh::Vec3d;
  using Normal = OpenMesh::Vec3d;
};
using Mesh = OpenMesh::TriMesh_ArrayKernelT<Traits>;

/// False when the triangles are no manifold: half-edges can't hold others.
bool build(const TriangleMesh& triangles, Mesh& mesh) {
  for (const Vec3& p : triangles.points) mesh.add_vertex({p.x(), p.y(), p.z()});
  for (const Triangle& t : triangles.triangles) {
    const auto face =
        mesh.add_face(mesh.vertex_handle(t[0]), mesh.vertex_handle(t[1]), mesh.vertex_handle(t[2]));
    if (!face.is_valid()) return false;
  }
  return true;
}

TriangleMesh as_triangles(const Mesh& mesh) {
  TriangleMesh triangles;
  for (const auto v : mesh.vertices()) {
    const auto& p = mesh.point(v);
    triangles.points.emplace_back(p[0], p[1], p[2]);
  }
  for (const auto f : mesh.faces()) {
    Triangle corners{};
    int i = 0;
    for (const auto v : mesh.fv_range(f)) corners[i++] = v.idx();
    triangles.triangles.push_back(corners);
  }
  return triangles;
}

}  // namespace

TriangleMesh decimate(const TriangleMesh& mesh, int triangles) {
  if (static_cast<int>(mesh.triangles.size()) <= triangles) return mesh;
  Mesh half_edges;
  half_edges.request_face_status();
  half_edges.request_edge_status();
  half_edges.request_halfedge_status();
  half_edges.request_vertex_status();
  half_edges.request_face_normals();
  if (!build(mesh, half_edges)) return mesh;
  half_edges.update_face_normals();

  OpenMesh::Decimater::DecimaterT<Mesh> decimater(half_edges);
  OpenMesh::Decimater::ModQuadricT<Mesh>::Handle quadric;
  decimater.add(quadric);
  decimater.module(quadric).unset_max_err();
  decimater.initialize();
  decimater.decimate_to_faces(0, static_cast<std::size_t>(triangles));
  half_edges.garbage_collection();
  return as_triangles(half_edges);
}

}  // namespace toile
