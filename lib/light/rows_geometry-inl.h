// Where the samples of rows_kernel-inl.h lie. Directions are not normalised: l = p - P and
// v = eye - P keep their lengths, and the cosines are ratios of sums of products, in double where
// they could cancel. Divisions, roots and logarithms are float: they take a processor many times as
// long in double.

// A length |a| within 1e-9 and 1e9: products of two squares are floats too.
template <class L>
struct Length {
  using F = typename L::F;
  F squared, length, inverse;
};

template <class L>
HWY_INLINE Length<L> length_of(typename L::D squared) {
  Length<L> a;
  a.squared = L::min(L::max(L::narrow(squared), L::f(1e-18F)), L::f(1e18F));
  a.length = L::root(a.squared);
  a.inverse = L::f(1) / a.length;
  return a;
}

// Samples as seen from the eye.
template <class L>
struct Seen {
  using D = typename L::D;
  D px, py, pz, nx, ny, nz, vx, vy, vz;
  D nv, nv2, vv;  // n.v, 2 n.v, v.v
  Length<L> v;
};

// A direction to a light.
template <class L>
struct Towards {
  using D = typename L::D;
  D x, y, z;     // l
  D nl, ll, lv;  // n.l, l.l, l.v
  Length<L> l;
};

template <class L>
HWY_INLINE typename L::D dot3(typename L::D ax, typename L::D ay, typename L::D az,
                              typename L::D bx, typename L::D by, typename L::D bz) {
  return ax * bx + ay * by + az * bz;
}

template <class L>
HWY_INLINE Seen<L> seen_at(const RowConstants& c, const SurfaceRows& s, std::size_t i) {
  Seen<L> at;
  at.px = L::load_wide(s.x.data() + i);
  at.py = L::load_wide(s.y.data() + i);
  at.pz = L::load_wide(s.z.data() + i);
  at.nx = L::load_wide(s.nx.data() + i);
  at.ny = L::load_wide(s.ny.data() + i);
  at.nz = L::load_wide(s.nz.data() + i);
  at.vx = L::d(c.eye_x);
  at.vy = L::d(c.eye_y);
  at.vz = L::d(c.eye_z);
  if (c.local_viewer) {
    at.vx = at.vx - at.px;
    at.vy = at.vy - at.py;
    at.vz = at.vz - at.pz;
  }
  at.nv = dot3<L>(at.nx, at.ny, at.nz, at.vx, at.vy, at.vz);
  at.nv2 = at.nv + at.nv;
  at.vv = dot3<L>(at.vx, at.vy, at.vz, at.vx, at.vy, at.vz);
  at.v = length_of<L>(at.vv);
  return at;
}

template <class L>
HWY_INLINE Towards<L> towards(const RowLight& light, const Seen<L>& at) {
  Towards<L> to;
  to.x = L::d(light.x);
  to.y = L::d(light.y);
  to.z = L::d(light.z);
  if (!light.directional) {
    to.x = to.x - at.px;
    to.y = to.y - at.py;
    to.z = to.z - at.pz;
  }
  to.nl = dot3<L>(at.nx, at.ny, at.nz, to.x, to.y, to.z);
  to.ll = dot3<L>(to.x, to.y, to.z, to.x, to.y, to.z);
  to.lv = dot3<L>(to.x, to.y, to.z, at.vx, at.vy, at.vz);
  to.l = length_of<L>(to.ll);
  return to;
}
