// Places and normals of samples, written once for one sample and for vectors; see
// lib/core/power-inl.h on how such files are included. `L` has floats F and doubles D.

// 1/sqrt(x): a step of Newton's from single precision, to 1e-13.
template <class L>
HWY_INLINE typename L::D inverse_root(typename L::D x) {
  using D = typename L::D;
  using F = typename L::F;
  const F rough = L::f(1) / L::root(L::max(L::narrow(x), L::f(1e-37F)));
  const D y = L::widen(rough);
  return y * (L::d(1.5) - L::d(0.5) * x * (y * y));
}

template <class L>
struct Vector {
  typename L::F x, y, z;
};

template <class L>
HWY_INLINE typename L::F ray_at(const HitRays& rays, int axis, typename L::F x, typename L::F y) {
  return L::f(rays.start[axis]) + (L::f(rays.dx[axis]) * x + L::f(rays.dy[axis]) * y);
}

// The place of a sample, from the eye.
template <class L>
HWY_INLINE Vector<L> place_of(const HitRays& rays, typename L::F x, typename L::F y,
                              typename L::F distance) {
  Vector<L> at{ray_at<L>(rays, 0, x, y), ray_at<L>(rays, 1, x, y), ray_at<L>(rays, 2, x, y)};
  if (rays.orthographic) {
    return {at.x + L::f(rays.along[0]) * distance, at.y + L::f(rays.along[1]) * distance,
            at.z + L::f(rays.along[2]) * distance};
  }
  return {at.x * distance, at.y * distance, at.z * distance};
}

// 1 where the normal is on the eye's side of the surface, else -1.
template <class L>
HWY_INLINE typename L::F side_of(const HitRays& rays, const Vector<L>& n, const Vector<L>& p) {
  using F = typename L::F;
  F away = n.x * p.x + n.y * p.y + n.z * p.z;
  if (rays.orthographic) {
    away = n.x * L::f(rays.along[0]) + n.y * L::f(rays.along[1]) + n.z * L::f(rays.along[2]);
  }
  return L::where_positive(away, L::f(-1), L::f(1));
}

template <class L>
HWY_INLINE void finish_at(const HitRays& rays, bool facing, HitRows& rows, std::size_t i) {
  using D = typename L::D;
  using F = typename L::F;
  const D nx = L::load_wide(rows.raw_x.data() + i);
  const D ny = L::load_wide(rows.raw_y.data() + i);
  const D nz = L::load_wide(rows.raw_z.data() + i);
  const D shrink = inverse_root<L>(nx * nx + (ny * ny + nz * nz));
  Vector<L> n{L::narrow(nx * shrink), L::narrow(ny * shrink), L::narrow(nz * shrink)};
  const F nearness = L::load(rows.nearness.data() + i);
  const F distance = rays.orthographic ? nearness : L::f(1) / nearness;
  const Vector<L> p = place_of<L>(rays, L::load(rows.sample_x.data() + i),
                                  L::load(rows.sample_y.data() + i), distance);
  if (facing) {
    const F side = side_of<L>(rays, n, p);
    n = {n.x * side, n.y * side, n.z * side};
  }
  L::store(distance, rows.distance.data() + i);
  L::store(p.x, rows.x.data() + i);
  L::store(p.y, rows.y.data() + i);
  L::store(p.z, rows.z.data() + i);
  L::store(n.x, rows.nx.data() + i);
  L::store(n.y, rows.ny.data() + i);
  L::store(n.z, rows.nz.data() + i);
}
