// The rows of rows.h, written once for one sample and for vectors; see lib/core/power-inl.h on how
// such files are included. Directions are not normalised: l = p - P and v = eye - P keep their
// lengths, and the cosines are ratios of sums of products, in double where they could cancel.

constexpr double kNothing = -1000;  // log2 of what comes out as 0

// Samples as seen from the eye.
template <class L>
struct Seen {
  using D = typename L::D;
  D px, py, pz, nx, ny, nz, vx, vy, vz;
  D nv, vv;  // n.v, v.v
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
  at.vv = dot3<L>(at.vx, at.vy, at.vz, at.vx, at.vy, at.vz);
  return at;
}

// log2 of (R.V)^n. (R.V)^2 = (2 (n.l)(n.v) - l.v)^2 / (l.l v.v).
template <class L>
HWY_INLINE typename L::D phong_power(const RowConstants& c, const Seen<L>& at, typename L::D nl,
                                     typename L::D lv, typename L::D ll) {
  using D = typename L::D;
  const D product = nl * at.nv;
  const D rv = (product + product) - lv;
  const D power = log2_of_ratio<L>(rv * rv, ll * at.vv) * L::d(c.exponent);
  return L::where_positive(rv, power, L::d(kNothing));
}

// |l + v| lengthens to both: (N.H)^2 = (n.l |v| + n.v |l|)^2 / (2 u (u + l.v)), u = |l||v|.
template <class L>
struct HalfVector {
  using D = typename L::D;
  D above, below;  // the fraction
  D u, w;          // w = u + l.v = u (1 + L.V)
};

template <class L>
HWY_INLINE HalfVector<L> half_vector_of(const Seen<L>& at, typename L::D nl, typename L::D lv,
                                        typename L::D ll) {
  using D = typename L::D;
  HalfVector<L> h;
  h.u = L::root(ll * at.vv);
  h.w = h.u + lv;
  const D mixed = nl * at.nv * h.u;
  h.above = nl * nl * at.vv + (mixed + mixed) + at.nv * at.nv * ll;
  h.below = L::max((h.u + h.u) * h.w, L::d(1e-300));
  return h;
}

// log2 of (N.H)^n; N.L is above 0 where it counts.
template <class L>
HWY_INLINE typename L::D blinn_power(const RowConstants& c, const Seen<L>& at,
                                     const HalfVector<L>& h, typename L::D nl, typename L::D ll) {
  using D = typename L::D;
  const D power = log2_of_ratio<L>(h.above, h.below) * L::d(c.exponent);
  const D sign = nl * nl * at.vv + at.nv * L::max(at.nv, L::d(0) - at.nv) * ll;
  return L::where_positive(sign, power, L::d(kNothing));
}

// Of a dielectric: 1/2 ((g-c)/(g+c))^2 (1 + ((c(g+c)-1)/(c(g-c)+1))^2), g^2 = eta^2 - 1 + c^2
// [Cook82]; g - c = (eta^2 - 1)/(g + c) keeps its digits for eta near 1. 1 at total reflection.
template <class L>
HWY_INLINE typename L::F fresnel_of(const RowConstants& c, typename L::F cosine2) {
  using F = typename L::F;
  const F g2 = L::f(c.eta2_minus_1) + cosine2;
  const F cosine = L::root(cosine2);
  const F sum = L::root(L::max(g2, L::f(0))) + cosine;
  const F difference = L::f(c.eta2_minus_1) / sum;
  const F a = difference / sum;
  const F b = (cosine * sum - L::f(1)) / (cosine * difference + L::f(1));
  return L::where_positive(g2, L::f(0.5F) * (a * a) * (b * b + L::f(1)), L::f(1));
}

// Beckmann's exponential exp(-(tan b / m)^2) times F G / (4 pi m^2 cos^4 b N.V); 0 where the eye is
// behind the surface.
template <class L>
HWY_INLINE typename L::F cook_torrance_lobe(const RowConstants& c, const HalfVector<L>& h,
                                            typename L::F n_dot_l, typename L::F n_dot_v) {
  using D = typename L::D;
  using F = typename L::F;
  const D sec2 = L::min(h.below / h.above, L::d(1e15));  // 1/(N.H)^2
  const F exponential = exp2_of<L>(L::min((sec2 - L::d(1)) * L::d(c.exponent), L::d(0)));
  const F sec2_f = L::narrow(sec2);
  const F vh2 = L::narrow(h.w) / L::narrow(h.u + h.u);  // (V.H)^2
  const F nv = L::max(n_dot_v, L::f(1e-30F));
  const F masked = L::min(n_dot_l, nv) / L::root(sec2_f * vh2);
  const F g = L::min(masked + masked, L::f(1));
  const F factor = fresnel_of<L>(c, vh2) * g * (sec2_f * sec2_f) * L::f(c.lobe_scale) / nv;
  return L::where_positive(n_dot_v, exponential * factor, L::f(0));
}

template <class L>
HWY_INLINE typename L::F attenuation_of(const RowLight& light, typename L::F distance) {
  using F = typename L::F;
  if (light.beer_lambert) {
    const F power = L::min(L::max(L::f(light.c1) * distance, L::f(-127)), L::f(127));
    const F whole = L::whole(power);
    return exp2_of_parts<L>(whole, power - whole);
  }
  const F sum = L::f(light.c1) + distance * (L::f(light.c2) + L::f(light.c3) * distance);
  return L::min(L::f(1) / sum, L::f(light.most));
}

// The light reflected so far.
template <class L>
struct Reflected {
  typename L::F r, g, b;
};

// The lobe of one light: l, n.l, l.l and the two cosines of the float part.
template <class L, RowLobe kLobe>
HWY_INLINE typename L::F lobe_of(const RowConstants& c, const Seen<L>& at, typename L::D nl,
                                 typename L::D lv, typename L::D ll, typename L::F n_dot_l,
                                 typename L::F n_dot_v) {
  if constexpr (kLobe == RowLobe::kPhong) return exp2_of<L>(phong_power<L>(c, at, nl, lv, ll));
  const HalfVector<L> h = half_vector_of<L>(at, nl, lv, ll);
  if constexpr (kLobe == RowLobe::kBlinnPhong) {
    return exp2_of<L>(blinn_power<L>(c, at, h, nl, ll));
  }
  return cook_torrance_lobe<L>(c, h, n_dot_l, n_dot_v);
}

template <class L>
HWY_INLINE typename L::F length_of(typename L::D squared) {
  return L::root(L::min(L::max(L::narrow(squared), L::f(1e-36F)), L::f(1e36F)));
}

template <class L, RowLobe kLobe>
HWY_INLINE void add_light(const RowConstants& c, const RowLight& light, const Seen<L>& at,
                          typename L::F n_dot_v, Reflected<L>& sum) {
  using D = typename L::D;
  using F = typename L::F;
  D lx = L::d(light.x);
  D ly = L::d(light.y);
  D lz = L::d(light.z);
  if (!light.directional) {
    lx = lx - at.px;
    ly = ly - at.py;
    lz = lz - at.pz;
  }
  const D nl = dot3<L>(at.nx, at.ny, at.nz, lx, ly, lz);
  const D ll = dot3<L>(lx, ly, lz, lx, ly, lz);
  F n_dot_l = L::narrow(nl);
  F f_att = L::f(1);
  if (!light.directional) {
    const F distance = length_of<L>(ll);
    n_dot_l = n_dot_l / distance;
    if (light.attenuated) f_att = attenuation_of<L>(light, distance);
  }
  f_att = L::where_positive(n_dot_l, f_att, L::f(0));
  const F diffuse = n_dot_l * f_att;
  sum.r = sum.r + L::f(light.diffuse_r) * diffuse;
  sum.g = sum.g + L::f(light.diffuse_g) * diffuse;
  sum.b = sum.b + L::f(light.diffuse_b) * diffuse;
  if constexpr (kLobe != RowLobe::kNone) {
    const D lv = dot3<L>(lx, ly, lz, at.vx, at.vy, at.vz);
    const F lobe = lobe_of<L, kLobe>(c, at, nl, lv, ll, n_dot_l, n_dot_v);
    const F specular = L::where_positive(f_att, lobe * f_att, L::f(0));
    sum.r = sum.r + L::f(light.specular_r) * specular;
    sum.g = sum.g + L::f(light.specular_g) * specular;
    sum.b = sum.b + L::f(light.specular_b) * specular;
  }
}

// One vector of samples, from `i` on.
template <class L, RowLobe kLobe>
HWY_INLINE void shade_at(const RowConstants& c, const SurfaceRows& surface, std::size_t i,
                         const LightRows& out) {
  using F = typename L::F;
  const Seen<L> at = seen_at<L>(c, surface, i);
  F n_dot_v = L::f(0);
  if constexpr (kLobe == RowLobe::kCookTorrance) {
    n_dot_v = L::narrow(at.nv) / length_of<L>(at.vv);
  }
  Reflected<L> sum{L::f(c.ambient_r), L::f(c.ambient_g), L::f(c.ambient_b)};
  for (const RowLight& light : c.lights) add_light<L, kLobe>(c, light, at, n_dot_v, sum);
  L::store(sum.r, out.r.data() + i);
  L::store(sum.g, out.g.data() + i);
  L::store(sum.b, out.b.data() + i);
}

// x^n of one vector.
template <class L>
HWY_INLINE typename L::F power_of(const float* x, double n) {
  using D = typename L::D;
  const D base = L::load_wide(x);
  const D power = log2_of_ratio<L>(base, L::d(1)) * L::d(n);
  return exp2_of<L>(L::where_positive(base, power, L::d(kNothing)));
}

// All whole vectors of a row; the number of samples that are left.
template <class L, RowLobe kLobe>
HWY_INLINE std::size_t shade_vectors(const RowConstants& c, const SurfaceRows& surface,
                                     const LightRows& out) {
  const std::size_t step = L::size();
  std::size_t i = 0;
  for (; i + step <= surface.x.size(); i += step) shade_at<L, kLobe>(c, surface, i, out);
  return surface.x.size() - i;
}

template <class L>
HWY_INLINE std::size_t shade_with_lobe(const RowConstants& c, const SurfaceRows& surface,
                                       const LightRows& out) {
  switch (c.lobe) {
    case RowLobe::kPhong:
      return shade_vectors<L, RowLobe::kPhong>(c, surface, out);
    case RowLobe::kBlinnPhong:
      return shade_vectors<L, RowLobe::kBlinnPhong>(c, surface, out);
    case RowLobe::kCookTorrance:
      return shade_vectors<L, RowLobe::kCookTorrance>(c, surface, out);
    case RowLobe::kNone:
      break;
  }
  return shade_vectors<L, RowLobe::kNone>(c, surface, out);
}
