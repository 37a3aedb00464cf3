// The rows of rows.h, written once for one sample and for vectors; see lib/core/power-inl.h on how
// such files are included. Behind rows_geometry-inl.h and rows_lobes-inl.h.

constexpr double kNothing = -1000;  // log2 of what comes out as 0

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

// OpenGL's spot: c^exponent inside of the cone and before the light; as spot_factor.
template <class L>
HWY_INLINE typename L::F spot_of(const RowLight& light, const Towards<L>& to) {
  using D = typename L::D;
  using F = typename L::F;
  const D cosine =
      dot3<L>(to.x, to.y, to.z, L::d(light.axis_x), L::d(light.axis_y), L::d(light.axis_z));
  const D before = L::max(cosine, L::d(0));
  const F above = L::narrow(before * before);
  const F power = power_of_ratio<L>(L::min(above, to.l.squared), to.l.squared, light.spot_exponent);
  const F outside =
      L::narrow(L::d(light.edge2) * to.ll - cosine * L::max(cosine, L::d(0) - cosine));
  return L::where_positive(outside, L::f(0), L::where_positive(above, power, L::f(0)));
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
    if (light.spot) f_att = f_att * spot_of<L>(light, to);
  }
  f_att = L::where_positive(n_dot_l, f_att, L::f(0));
  const F diffuse = n_dot_l * f_att;
  sum.r = sum.r + L::f(light.diffuse_r) * diffuse;
  sum.g = sum.g + L::f(light.diffuse_g) * diffuse;
  sum.b = sum.b + L::f(light.diffuse_b) * diffuse;
  if constexpr (kLobe != RowLobe::kNone && kLobe != RowLobe::kFacets) {
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
  if constexpr (kLobe == RowLobe::kFacets) return facets_at<L>(c, at, n_dot_v, i, out);
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
    case RowLobe::kFacets:
      return shade_vectors<L, RowLobe::kFacets>(c, surface, out);
    case RowLobe::kNone:
      break;
  }
  return shade_vectors<L, RowLobe::kNone>(c, surface, out);
}
