// Powers of float precision, written once for one sample and for vectors.
//
// Included inside of a namespace by the files that instantiate it, so no guard and no includes. `L`
// (lanes_scalar.h, lanes-inl.h) has floats F and doubles D, and what operators do not say. Nothing
// is fused, and the order is fixed: every instantiation gives the same bits. Polynomials are summed
// in pairs (Estrin's scheme), which leaves less to wait for than Horner's.

// log2(a/b) of two positive doubles, with a relative error of 3e-11.
template <class L>
HWY_INLINE typename L::D log2_of_ratio(typename L::D a, typename L::D b) {
  using D = typename L::D;
  // a is brought near to b by the power of 2 that their bit patterns tell.
  D exponent;
  const D m = L::scale_near(a, b, exponent);
  const D s = (m - b) / (m + b);  // |s| <= .201
  const D z = s * s;
  // 2 atanh(s) / (s ln 2), interpolated at the Chebyshev nodes of [0, .0404]: to 2.2e-11.
  const D low = L::d(0x1.71547652d93eap+1) + L::d(0x1.ec709b44cce42p-1) * z;
  const D high = L::d(0x1.2778b16c274d6p-1) + L::d(0x1.a50ee7c996931p-2) * z;
  const D z2 = z * z;
  return exponent + s * (low + z2 * (high + L::d(0x1.6500e45fac07dp-2) * z2));
}

// 2^(whole + part) for whole numbers and |part| <= 1/2; 0 below 2^-126. Maximum error 1.3 ulp.
template <class L>
HWY_INLINE typename L::F exp2_of_parts(typename L::F whole, typename L::F part) {
  using F = typename L::F;
  // (2^x - 1)/x interpolated at the Chebyshev nodes of [-1/2, 1/2]: 2^x to 5.1e-9, exact at 0.
  const F x2 = part * part;
  const F low = L::f(1) + L::f(0x1.62e43p-1F) * part;
  const F middle = L::f(0x1.ebfbep-3F) + L::f(0x1.c6af6cp-5F) * part;
  const F high = L::f(0x1.3b2a54p-7F) + L::f(0x1.5f089p-10F) * part;
  const F p = low + x2 * (middle + x2 * (high + L::f(0x1.44138ap-13F) * x2));
  return p * L::power_of_two(L::min(L::max(whole, L::f(-127)), L::f(128)));
}

// 2^t for |t| < 2^51.
template <class L>
HWY_INLINE typename L::F exp2_of(typename L::D t) {
  using D = typename L::D;
  const D whole = L::whole(t);
  return exp2_of_parts<L>(L::narrow(whole), L::narrow(t - whole));
}

// (a/b)^n of two positive floats, no subnormals, for a <= b or a finite result. Maximum error
// 1e-7 n + 2e-7 relative: that of the logarithm counts n times.
template <class L>
HWY_INLINE typename L::F power_of_ratio(typename L::F a, typename L::F b, const Exponent& n) {
  using F = typename L::F;
  F exponent;
  const F m = L::scale_near(a, b, exponent);
  const F s = (m - b) / (m + b);  // |s| <= .201
  const F z = s * s;
  // As in log2_of_ratio, to 1.3e-8 with these coefficients.
  const F low = L::f(0x1.715476p+1F) + L::f(0x1.ec715cp-1F) * z;
  const F high = L::f(0x1.271bb2p-1F) + L::f(0x1.c1dfaap-2F) * z;
  const F part = s * (low + (z * z) * high);
  // n (exponent + part): the head of n times the exponent is exact.
  const F exact = L::f(n.head) * exponent;
  const F rest = L::f(n.tail) * exponent + L::f(n.all) * part;
  const F whole = L::whole(exact + rest);
  return exp2_of_parts<L>(whole, (exact - whole) + rest);
}
