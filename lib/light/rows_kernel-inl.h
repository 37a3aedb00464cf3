// The rows of rows.h, written once for one sample and for vectors; see lib/core/power-inl.h on how
// such files are included. Directions are not normalised: l = p - P and v = eye - P keep their
// lengths, and the cosines are ratios of sums of products, in double where they could cancel.
// Divisions, roots and logarithms are float: they take a processor many times as long in double.

constexpr double kNothing = -1000;  // log2 of what comes out as 0

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
  using D = typename L::D;
  D lx = L::d(light.x);
  D ly = L::d(light.y);
  D lz = L::d(light.z);
  if (!light.directional) {
    lx = lx - at.px;
    ly = ly - at.py;
    lz = lz - at.pz;
  }
  Towards<L> to;
  to.nl = dot3<L>(at.nx, at.ny, at.nz, lx, ly, lz);
  to.ll = dot3<L>(lx, ly, lz, lx, ly, lz);
  to.lv = dot3<L>(lx, ly, lz, at.vx, at.vy, at.vz);
  to.l = length_of<L>(to.ll);
  return to;
}

// (R.V)^n. (R.V)^2 = (2 (n.l)(n.v) - l.v)^2 / (l.l v.v).
template <class L>
HWY_INLINE typename L::F phong_lobe(const RowConstants& c, const Seen<L>& at,
                                    const Towards<L>& to) {
  using D = typename L::D;
  using F = typename L::F;
  const D rv = L::max(to.nl * at.nv2 - to.lv, L::d(0));
  const F above = L::narrow(rv * rv);
  const F below = to.l.squared * at.v.squared;
  return L::where_positive(above, power_of_ratio<L>(L::min(above, below), below, c.exponent),
                           L::f(0));
}

// |l + v| lengthens to both: (N.H)^2 = (n.l |v| + n.v |l|)^2 / (2 u (u + l.v)), u = |l||v|.
template <class L>
struct HalfVector {
  using D = typename L::D;
  using F = typename L::F;
  D above, below;  // the fraction
  F vh2;           // (V.H)^2 = (u + l.v) / (2 u)
};

template <class L>
HWY_INLINE HalfVector<L> half_vector_of(const Seen<L>& at, const Towards<L>& to) {
  using D = typename L::D;
  using F = typename L::F;
  // A step of Newton's from u in single precision to nearly all digits of a double.
  const F half_inverse = L::f(0.5F) * (to.l.inverse * at.v.inverse);
  const D rough = L::widen(to.l.length * at.v.length);
  const D u = rough + (to.ll * at.vv - rough * rough) * L::widen(half_inverse);
  const D w = u + to.lv;
  HalfVector<L> h;
  h.above = to.nl * (to.nl * at.vv + at.nv2 * u) + at.nv * at.nv * to.ll;
  h.below = (u + u) * w;
  h.vh2 = L::max(L::narrow(w) * half_inverse, L::f(1e-20F));
  return h;
}

// (N.H)^n; N.L is above 0 where it counts.
template <class L>
HWY_INLINE typename L::F blinn_lobe(const RowConstants& c, const Seen<L>& at,
                                    const Towards<L>& to) {
  using D = typename L::D;
  using F = typename L::F;
  const HalfVector<L> h = half_vector_of<L>(at, to);
  const F below = L::min(L::max(L::narrow(h.below), L::f(1e-37F)), L::f(1e37F));
  const F power = power_of_ratio<L>(L::min(L::narrow(h.above), below), below, c.exponent);
  const D behind = L::max(at.nv, L::d(0) - at.nv) * at.nv;
  return L::where_positive(L::narrow(to.nl * to.nl * at.vv + behind * to.ll), power, L::f(0));
}

// F/(V.H)^2 of a dielectric: F = 1/2 ((g-c)/(g+c))^2 (1 + ((c(g+c)-1)/(c(g-c)+1))^2),
// g^2 = eta^2 - 1 + c^2 [Cook82]; g - c = (eta^2 - 1)/(g + c) keeps its digits for eta near 1. All
// fractions by one division. F is 1 at total reflection.
template <class L>
struct Fresnel {
  typename L::F reflected, inverse_vh2;
};

template <class L>
HWY_INLINE Fresnel<L> fresnel_of(const RowConstants& c, typename L::F vh2) {
  using F = typename L::F;
  const F k = L::f(c.eta2_minus_1);
  const F g2 = k + vh2;
  const F cosine = L::root(vh2);
  const F sum = L::root(L::max(g2, L::f(0))) + cosine;
  const F sum2 = sum * sum;
  const F b_below = cosine * k + sum;
  const F bottom = sum2 * b_below;
  const F inverse = L::f(1) / (bottom * vh2);
  const F a = k * b_below * vh2 * inverse;
  const F b = (cosine * sum2 - sum) * sum2 * vh2 * inverse;
  return {L::where_positive(g2, L::f(0.5F) * (a * a) * (b * b + L::f(1)), L::f(1)),
          bottom * inverse};
}

// Beckmann's exponential exp(-(tan b / m)^2) and 1/cos^2 b.
template <class L>
struct Beckmann {
  typename L::F exponential, sec2;
};

template <class L>
HWY_INLINE Beckmann<L> beckmann_of(const RowConstants& c, const HalfVector<L>& h) {
  using D = typename L::D;
  using F = typename L::F;
  // log2 of it is a fraction, in two floats: the second is what the first leaves of it.
  const F below = L::max(L::narrow(h.above), L::f(1e-37F));
  const F inverse = L::f(1) / below;
  const D above = (h.below - h.above) * L::d(c.tangent_scale);
  const F power = L::max(L::min(L::narrow(above) * inverse, L::f(0)), L::f(-1000));
  const F left = L::narrow(above - L::widen(power) * h.above) * inverse;
  const F whole = L::whole(power);
  const F part = (power - whole) + L::max(L::min(left, L::f(1)), L::f(-1));
  return {exp2_of_parts<L>(whole, part), L::f(1) + power * L::f(c.tangent_unscale)};
}

// D F G / (4 N.V), D = exp(-(tan b / m)^2) / (pi m^2 cos^4 b), G = min(1, (N.L + N.V) min(N.L, N.V)
// / (V.H)^2); 0 behind the surface.
template <class L>
HWY_INLINE typename L::F cook_torrance_lobe(const RowConstants& c, const Seen<L>& at,
                                            const Towards<L>& to, typename L::F n_dot_l,
                                            typename L::F n_dot_v) {
  using F = typename L::F;
  const HalfVector<L> h = half_vector_of<L>(at, to);
  const Beckmann<L> d = beckmann_of<L>(c, h);
  const Fresnel<L> f = fresnel_of<L>(c, h.vh2);
  const F nv = L::max(n_dot_v, L::f(1e-30F));
  const F g = L::min((n_dot_l + nv) * L::min(n_dot_l, nv) * f.inverse_vh2, L::f(1));
  const F factor = f.reflected * g * (d.sec2 * d.sec2) * (L::f(c.lobe_scale) / nv);
  return L::where_positive(L::min(n_dot_l, n_dot_v), d.exponential * factor, L::f(0));
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

template <class L, RowLobe kLobe>
HWY_INLINE typename L::F lobe_of(const RowConstants& c, const Seen<L>& at, const Towards<L>& to,
                                 typename L::F n_dot_l, typename L::F n_dot_v) {
  if constexpr (kLobe == RowLobe::kPhong) return phong_lobe<L>(c, at, to);
  if constexpr (kLobe == RowLobe::kBlinnPhong) return blinn_lobe<L>(c, at, to);
  return cook_torrance_lobe<L>(c, at, to, n_dot_l, n_dot_v);
}

template <class L, RowLobe kLobe>
HWY_INLINE void add_light(const RowConstants& c, const RowLight& light, const Seen<L>& at,
                          typename L::F n_dot_v, Reflected<L>& sum) {
  using F = typename L::F;
  const Towards<L> to = towards<L>(light, at);
  F n_dot_l = L::narrow(to.nl);
  F f_att = L::f(1);
  if (!light.directional) {
    n_dot_l = n_dot_l * to.l.inverse;
    if (light.attenuated) f_att = attenuation_of<L>(light, to.l.length);
  }
  f_att = L::where_positive(n_dot_l, f_att, L::f(0));
  const F diffuse = n_dot_l * f_att;
  sum.r = sum.r + L::f(light.diffuse_r) * diffuse;
  sum.g = sum.g + L::f(light.diffuse_g) * diffuse;
  sum.b = sum.b + L::f(light.diffuse_b) * diffuse;
  if constexpr (kLobe != RowLobe::kNone) {
    const F lobe = lobe_of<L, kLobe>(c, at, to, n_dot_l, n_dot_v);
    const F specular = lobe * f_att;
    sum.r = sum.r + L::f(light.specular_r) * specular;
    sum.g = sum.g + L::f(light.specular_g) * specular;
    sum.b = sum.b + L::f(light.specular_b) * specular;
  }
}

// One vector of samples, from `i` on.
template <class L, RowLobe kLobe>
HWY_INLINE void shade_at(const RowConstants& c, const SurfaceRows& surface, std::size_t i,
                         const LightRows& out) {
  const Seen<L> at = seen_at<L>(c, surface, i);
  const typename L::F n_dot_v = L::narrow(at.nv) * at.v.inverse;
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
