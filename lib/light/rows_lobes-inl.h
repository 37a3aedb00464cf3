// The specular lobes of rows_kernel-inl.h.

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
HWY_INLINE typename L::F facet_lobe(const RowConstants& c, const HalfVector<L>& h,
                                    const Fresnel<L>& f, typename L::F n_dot_l,
                                    typename L::F n_dot_v) {
  using F = typename L::F;
  const Beckmann<L> d = beckmann_of<L>(c, h);
  const F nv = L::max(n_dot_v, L::f(1e-30F));
  const F g = L::min((n_dot_l + nv) * L::min(n_dot_l, nv) * f.inverse_vh2, L::f(1));
  const F factor = f.reflected * g * (d.sec2 * d.sec2) * (L::f(c.lobe_scale) / nv);
  return L::where_positive(L::min(n_dot_l, n_dot_v), d.exponential * factor, L::f(0));
}

template <class L>
HWY_INLINE typename L::F cook_torrance_lobe(const RowConstants& c, const Seen<L>& at,
                                            const Towards<L>& to, typename L::F n_dot_l,
                                            typename L::F n_dot_v) {
  const HalfVector<L> h = half_vector_of<L>(at, to);
  return facet_lobe<L>(c, h, fresnel_of<L>(c, h.vh2), n_dot_l, n_dot_v);
}

// RowLobe::kFacets, of the first light.
template <class L>
HWY_INLINE void facets_at(const RowConstants& c, const Seen<L>& at, typename L::F n_dot_v,
                          std::size_t i, const LightRows& out) {
  using F = typename L::F;
  const RowLight& light = c.lights[0];
  const Towards<L> to = towards<L>(light, at);
  F n_dot_l = L::narrow(to.nl);
  F f_att = L::f(1);
  if (!light.directional) {
    n_dot_l = n_dot_l * to.l.inverse;
    if (light.attenuated) f_att = attenuation_of<L>(light, to.l.length);
    if (light.spot) f_att = f_att * spot_of<L>(light, to);
  }
  const HalfVector<L> h = half_vector_of<L>(at, to);
  const Fresnel<L> all{L::f(1), L::f(1) / h.vh2};
  const F lobe = facet_lobe<L>(c, h, all, n_dot_l, n_dot_v);
  L::store(lobe * f_att, out.r.data() + i);
  L::store(L::root(h.vh2), out.g.data() + i);
}
