// Greedy expectation maximisation of a 1-D Gaussian mixture in one launch of one work-group of any size; the
// order of steps is that of mixture.cxx. Every work-item keeps the small state for itself, all alike, and
// sums over its own samples, so an EM step needs one reduction and nothing else. REAL is double where the
// device has it, else float; V holds WIDTH of them: 1 where work-items are the vector lanes, 8 where there is
// one work-item. MAXIMUM is the largest number of components, TINY a number whose square is normal.
#ifdef USE_DOUBLE
#pragma OPENCL EXTENSION cl_khr_fp64 : enable
#endif

#define JOIN_(a, b) a##b
#define JOIN(a, b) JOIN_(a, b)
#if WIDTH == 1
#define V REAL
#define GROUP
#define UNROLL
#define FULL(vectors) (vectors)
#define LOAD(i, p) (p)[i]
#define STORE(v, i, p) (p)[i] = (v)
#define TOTAL(v) (v)
#define LEAST(v) (v)
#else
#define V JOIN(REAL, 8)
#define GROUP __attribute__((reqd_work_group_size(1, 1, 1)))
#define UNROLL _Pragma("unroll")
#define FULL(vectors) ((vectors)-1)
#define LOAD(i, p) vload8(i, p)
#define STORE(v, i, p) vstore8(v, i, p)
#define TOTAL(v) ((((v).s0 + (v).s1) + ((v).s2 + (v).s3)) + (((v).s4 + (v).s5) + ((v).s6 + (v).s7)))
#define LEAST(v)                                                                                             \
  min(min(min((v).s0, (v).s1), min((v).s2, (v).s3)), min(min((v).s4, (v).s5), min((v).s6, (v).s7)))
#ifdef USE_DOUBLE
#define BITS long8
#define MANTISSA 52
#define BIAS 1023
#else
#define BITS int8
#define MANTISSA 23
#define BIAS 127
#endif
#endif

#define INLINE inline __attribute__((always_inline)) // calls would keep vectors in memory
// A constant number of rounds, so that the compiler unrolls the loop and keeps arrays in registers.
#define EACH(j, count)                                                                                       \
  UNROLL                                                                                                     \
  for (int j = 0; j < MAXIMUM; ++j)                                                                          \
    if (j < (count))
#define WEIGHT(k) (3 * (k))
#define MEAN(k) (3 * (k) + 1)
#define VARIANCE(k) (3 * (k) + 2)
#define FIRST (int)get_local_id(0)
#define STRIDE (int)get_local_size(0)
#define TWO_PI ((REAL)6.283185307179586)
#define LOG2_E ((REAL)1.4426950408889634)
#define LN_2 ((REAL)0.6931471805599453)
#define TOGETHER 4 // candidates to one reduction

// 2^t for t <= 1000. The device's own is as good for a single number; as vectors its calls cost several times
// the arithmetic. Below 2^-1000 everything is 2^-1000: nothing beside the largest component.
#if defined(USE_DOUBLE) && WIDTH > 1
INLINE V power2(V t)
{
  const V shift = (V)(6755399441055744.0); // 1.5 * 2^52: the sum's last bits are the nearest whole number
  t = max(t, (V)(-1000.0));
  const V whole = t + shift;
  const V r = t - (whole - shift);
  // The polynomial of degree 7 that is nearest to 2^r on [-1/2, 1/2], off by at most 4.1e-11 of the value.
  V p = r * 1.52019232278869171e-05 + 0.000154692911488946333;
  p = p * r + 0.00133339225562943514;
  p = p * r + 0.00961802725364381069;
  p = p * r + 0.0555041035345692350;
  p = p * r + 0.240226511981578894;
  p = p * r + 0.693147180728444573;
  p = p * r + 0.999999999961681759;
  return as_double8(as_long8(p) + (as_long8(whole) << 52));
}
#else
#define power2(t) exp2(t)
#endif

// The logarithm of a product, by one call at the end where calls are dear: factors between 1 and 2, exponents
// added.
typedef struct
{
#if WIDTH == 1
  V logs;
#else
  V mantissas;
  BITS exponents;
  int factors;
#endif
} Product;

INLINE void clear(Product* product)
{
#if WIDTH == 1
  product->logs = 0;
#else
  product->mantissas = (V)(1);
  product->exponents = (BITS)(0);
  product->factors = 0;
#endif
}

INLINE void multiply(Product* product, const V factor)
{
#if WIDTH == 1
  product->logs += log2(factor);
#else
  const BITS bits = JOIN(as_, BITS)(product->mantissas * factor);
  product->exponents += bits >> MANTISSA;
  product->mantissas =
    JOIN(as_, V)((bits & (((BITS)(1) << MANTISSA) - (BITS)(1))) | ((BITS)(BIAS) << MANTISSA));
  product->factors += 1;
#endif
}

INLINE REAL log2Of(const Product* product)
{
#if WIDTH == 1
  return product->logs;
#else
  const V logs = log2(product->mantissas);
  return TOTAL(logs) + (REAL)(TOTAL(product->exponents) - WIDTH * BIAS * product->factors);
#endif
}

// log2(weight N(x; mean, variance)) is height - steepness (x - mean)^2.
INLINE REAL heightOf(const REAL weight, const REAL variance)
{
  return log2(weight) - (REAL)0.5 * log2(TWO_PI * variance);
}
INLINE REAL steepnessOf(const REAL variance)
{
  return (REAL)0.5 * LOG2_E / variance;
}

// Sums `count` values of each work-item over the work-group; every work-item gets the sums.
INLINE void sumOverGroup(REAL* values, const int count, local REAL* work)
{
#if WIDTH == 1
  const int item = (int)get_local_id(0);
  const int size = (int)get_local_size(0);
  for (int j = 0; j < count; ++j)
  {
    work[j * size + item] = values[j];
  }
  barrier(CLK_LOCAL_MEM_FENCE);
  for (int left = size; left > 1; left = (left + 1) / 2)
  {
    const int upper = (left + 1) / 2;
    if (item < left / 2)
    {
      for (int j = 0; j < count; ++j)
      {
        work[j * size + item] += work[j * size + item + upper];
      }
    }
    barrier(CLK_LOCAL_MEM_FENCE);
  }
  for (int j = 0; j < count; ++j)
  {
    values[j] = work[j * size];
  }
  barrier(CLK_LOCAL_MEM_FENCE);
#endif
}

typedef struct
{
  int n, vectors, candidates, kept, maximumSteps;
  global const REAL *samples, *inside, *means;
  REAL width, peak, fall, floor, gain; // peak and fall: height and steepness of a candidate
  global REAL* density;
  local REAL *work, *shapes;
} Task;

// Per component the sums of r, r d and r d^2, r its share of a sample and d the sample's distance from its
// mean; then what makes the log-likelihood.
typedef struct
{
  REAL height[MAXIMUM], steepness[MAXIMUM], mean[MAXIMUM];
  V mass[MAXIMUM], first[MAXIMUM], second[MAXIMUM];
  V heights, least;
  Product product;
} Sums;

// Adds the samples x; in is 0 for padding, else 1. far: samples may be so far from all means that their
// densities underflow; the largest is taken out.
INLINE void addSums(const int components, const bool far, const V x, const V in, Sums* sums)
{
  V terms[MAXIMUM], off[MAXIMUM];
  V largest = (V)(far ? -INFINITY : 0);
  EACH(j, components)
  {
    off[j] = x - sums->mean[j];
    terms[j] = sums->height[j] - off[j] * off[j] * sums->steepness[j];
    largest = far ? max(largest, terms[j]) : largest;
  }
  V sum = (V)(0);
  EACH(j, components)
  {
    terms[j] = power2(far ? terms[j] - largest : terms[j]);
    sum += terms[j];
  }
  sums->heights += far ? in * largest : (V)(0);
  sums->least = min(sums->least, sum);
  multiply(&sums->product, in > 0 ? sum : (V)(1));
  const V inverse = in / sum;
  EACH(j, components)
  {
    V share = terms[j] * inverse;
    sums->mass[j] += share;
    share *= off[j];
    sums->first[j] += share;
    sums->second[j] += share * off[j];
  }
}

// The sums over this work-item's samples, three for each component, then the log-likelihood. Returns whether
// no sample's density came near an underflow.
INLINE bool ownSums(const int components, const bool far, const Task* task, const REAL* mixture, REAL* result)
{
  Sums sums;
  EACH(j, components)
  {
    sums.height[j] = heightOf(mixture[WEIGHT(j)], mixture[VARIANCE(j)]);
    sums.steepness[j] = steepnessOf(mixture[VARIANCE(j)]);
    sums.mean[j] = mixture[MEAN(j)];
    sums.mass[j] = sums.first[j] = sums.second[j] = (V)(0);
  }
  sums.heights = (V)(0);
  sums.least = (V)(1);
  clear(&sums.product);
  for (int i = FIRST; i < FULL(task->vectors); i += STRIDE)
  {
    addSums(components, far, LOAD(i, task->samples), (V)(1), &sums);
  }
#if WIDTH > 1
  addSums(components, far, LOAD(task->vectors - 1, task->samples), LOAD(0, task->inside), &sums);
#endif
  EACH(j, components)
  {
    result[3 * j] = TOTAL(sums.mass[j]);
    result[3 * j + 1] = TOTAL(sums.first[j]);
    result[3 * j + 2] = TOTAL(sums.second[j]);
  }
  result[3 * components] = LN_2 * (TOTAL(sums.heights) + log2Of(&sums.product));
  return LEAST(sums.least) > (REAL)TINY;
}

// One EM step: `next` from `mixture`. Returns the log-likelihood of `mixture`.
INLINE REAL step(const int components, const Task* task, const REAL* mixture, REAL* next)
{
  REAL sums[3 * MAXIMUM + 1];
  if (!ownSums(components, false, task, mixture, sums))
  {
    ownSums(components, true, task, mixture, sums);
  }
  sumOverGroup(sums, 3 * components + 1, task->work);
  for (int k = 0; k < components; ++k)
  {
    const REAL mass = sums[3 * k];
    const REAL away = mass > 0 ? sums[3 * k + 1] / mass : (REAL)0;
    const REAL spread = mass > 0 ? sums[3 * k + 2] / mass - away * away : (REAL)0;
    next[WEIGHT(k)] = max(mass / task->n, (REAL)1e-12);
    next[MEAN(k)] = mixture[MEAN(k)] + away;
    next[VARIANCE(k)] = max(spread, task->floor);
  }
  return sums[3 * components];
}

// What a candidate's score is made of: the sums of delta and delta^2, and the log-likelihood of mixture and
// candidate in equal shares.
typedef struct
{
  V sum, squares;
  Product product;
} Score;

// Adds two vectors of samples with the mixture's density and the candidate's there, by one division; in is 0
// for padding, else 1.
INLINE void addScores(const V density1,
  const V shape1,
  const V in1,
  const V density2,
  const V shape2,
  const V in2,
  Score* score)
{
  const V total1 = in1 > 0 ? max(density1 + shape1, (V)(TINY)) : (V)(1); // both may underflow
  const V total2 = in2 > 0 ? max(density2 + shape2, (V)(TINY)) : (V)(1);
  const V both = total1 * total2;
  multiply(&score->product, both);
  const V inverse = 1 / both;
  const V delta1 = in1 * (density1 - shape1) * (total2 * inverse);
  const V delta2 = in2 * (density2 - shape2) * (total1 * inverse);
  score->sum += delta1 + delta2;
  score->squares += delta1 * delta1 + delta2 * delta2;
}

// The density of a candidate at the samples of vector i: made, or found in local memory, where it is kept for
// the next insertions.
INLINE V shapeAt(const Task* task, const bool keep, const bool found, const int candidate, const int i)
{
  const int place = candidate * task->vectors + i;
  if (found)
  {
    return LOAD(place, task->shapes);
  }
  const V off = LOAD(i, task->samples) - task->means[candidate];
  const V shape = power2(task->peak - off * off * task->fall);
  if (keep)
  {
    STORE(shape, place, task->shapes);
  }
  return shape;
}

// The score's three sums over this work-item's samples.
INLINE void ownScore(const Task* task, const bool keep, const bool found, const int candidate, REAL* result)
{
  Score score;
  score.sum = score.squares = (V)(0);
  clear(&score.product);
  int i = FIRST;
  for (; i + STRIDE < FULL(task->vectors); i += 2 * STRIDE)
  {
    addScores(LOAD(i, task->density),
      shapeAt(task, keep, found, candidate, i),
      (V)(1),
      LOAD(i + STRIDE, task->density),
      shapeAt(task, keep, found, candidate, i + STRIDE),
      (V)(1),
      &score);
  }
  V density = (V)(0), shape = (V)(0), in = (V)(0);
  if (i < FULL(task->vectors))
  {
    density = LOAD(i, task->density);
    shape = shapeAt(task, keep, found, candidate, i);
    in = (V)(1);
  }
#if WIDTH > 1
  const int last = task->vectors - 1;
  addScores(density,
    shape,
    in,
    LOAD(last, task->density),
    shapeAt(task, keep, found, candidate, last),
    LOAD(0, task->inside),
    &score);
#else
  addScores(density, shape, in, (V)(0), (V)(0), (V)(0), &score);
#endif
  result[0] = LN_2 * log2Of(&score.product);
  result[1] = TOTAL(score.sum);
  result[2] = TOTAL(score.squares);
}

typedef struct
{
  REAL mixture[3 * MAXIMUM];
  REAL likelihood;
  int components, steps;
} Fit;

// Inserts one more component into a fit with so many and runs EM. False, and the fit as it was, when the
// likelihood does not rise.
INLINE bool insert(const int components, const Task* task, Fit* fit)
{
  REAL height[MAXIMUM], steepness[MAXIMUM];
  for (int j = 0; j < components; ++j)
  {
    height[j] = heightOf(fit->mixture[WEIGHT(j)], fit->mixture[VARIANCE(j)]);
    steepness[j] = steepnessOf(fit->mixture[VARIANCE(j)]);
  }
  for (int i = FIRST; i < task->vectors; i += STRIDE)
  {
    const V x = LOAD(i, task->samples);
    V sum = (V)(0);
    for (int j = 0; j < components; ++j)
    {
      const V off = x - fit->mixture[MEAN(j)];
      sum += power2(height[j] - off * off * steepness[j]);
    }
    STORE(sum, i, task->density);
  }

  REAL bestWeight = (REAL)0.5, bestMean = 0, best = -INFINITY;
  for (int c = 0; c < task->candidates; c += TOGETHER)
  {
    REAL sums[3 * TOGETHER];
    const int these = min(TOGETHER, task->candidates - c);
    for (int j = 0; j < these; ++j)
    {
      if (c + j >= task->kept)
      {
        ownScore(task, false, false, c + j, sums + 3 * j);
      }
      else
      {
        ownScore(task, true, components > 1, c + j, sums + 3 * j);
      }
    }
    sumOverGroup(sums, 3 * these, task->work);
    for (int j = 0; j < these; ++j)
    {
      const REAL b = sums[3 * j + 1], d = sums[3 * j + 2];
      const REAL weight = d > 0 ? clamp((REAL)0.5 - (REAL)0.5 * b / d, (REAL)0.01, (REAL)0.99) : (REAL)0.5;
      const REAL away = weight - (REAL)0.5;
      const REAL score = sums[3 * j] - LN_2 * task->n - 2 * away * b - 2 * away * away * d;
      if (d > 0 && score > best)
      {
        best = score;
        bestWeight = weight;
        bestMean = task->means[c + j];
      }
    }
  }

  REAL trial[3 * MAXIMUM], next[3 * MAXIMUM], converged[3 * MAXIMUM];
  for (int j = 0; j < components; ++j)
  {
    trial[WEIGHT(j)] = (1 - bestWeight) * fit->mixture[WEIGHT(j)];
    trial[MEAN(j)] = fit->mixture[MEAN(j)];
    trial[VARIANCE(j)] = fit->mixture[VARIANCE(j)];
  }
  trial[WEIGHT(components)] = bestWeight;
  trial[MEAN(components)] = bestMean;
  trial[VARIANCE(components)] = task->width;

  REAL reached = -INFINITY;
  bool rises = true;
  for (int s = 0; s < task->maximumSteps && rises; ++s)
  {
    const REAL now = step(components + 1, task, trial, next);
    ++fit->steps;
    // Only a variance at its floor can make the likelihood fall; then the mixture before stands.
    rises = now > reached + task->gain;
    const bool better = now > reached;
    reached = better ? now : reached;
    for (int j = 0; j < 3 * (components + 1); ++j)
    {
      converged[j] = better ? trial[j] : converged[j];
      trial[j] = next[j];
    }
  }
  if (!(reached > fit->likelihood + task->gain))
  {
    return false;
  }
  fit->likelihood = reached;
  ++fit->components;
  for (int j = 0; j < 3 * (components + 1); ++j)
  {
    fit->mixture[j] = converged[j];
  }
  return true;
}

// input: `vectors` of V with the n samples, the last one padded; one V with 1 for a sample of the last
// vector, 0 for padding; the candidates' means. density: scratch for a number at each sample. shapes: the
// same for each of the first `kept` candidates. result: weight, mean, variance per component, then the
// log-likelihood, the number of components and of EM steps.
kernel GROUP void greedyMixture(const int n,
  const int vectors,
  const int candidates,
  const int kept,
  global const REAL* input,
  const REAL width,
  const REAL floor_,
  const int maximumSteps,
  const REAL gain,
  global REAL* density,
  local REAL* work,
  local REAL* shapes,
  global REAL* result)
{
  Task task;
  task.n = n;
  task.vectors = vectors;
  task.candidates = candidates;
  task.maximumSteps = maximumSteps;
  task.samples = input;
  task.inside = task.samples + vectors * WIDTH;
  task.means = task.inside + WIDTH;
  task.width = width;
  task.peak = heightOf(1, width);
  task.fall = steepnessOf(width);
  task.floor = floor_;
  task.gain = gain;
  task.density = density;
  task.work = work;
  task.shapes = shapes;
  task.kept = kept;
  // The first step lands on the samples' own mean and variance, the second tells its likelihood.
  const REAL start[3] = { 1, input[0], 1 };
  REAL next[3];
  Fit fit;
  step(1, &task, start, fit.mixture);
  fit.likelihood = step(1, &task, fit.mixture, next);
  fit.components = 1;
  fit.steps = 1;
#if WIDTH == 1
  for (bool more = true; more && fit.components < MAXIMUM;)
  {
    more = insert(fit.components, &task, &fit);
  }
#else
  // With the number of components known, the compiler keeps everything in registers: a call for each number.
#define INSERT(k) (k < MAXIMUM && insert(min(k, MAXIMUM - 1), &task, &fit))
  const bool all = INSERT(1) && INSERT(2) && INSERT(3) && INSERT(4) && INSERT(5) && INSERT(6) && INSERT(7);
  (void)all;
#endif
  if (get_local_id(0) == 0)
  {
    for (int j = 0; j < 3 * fit.components; ++j)
    {
      result[j] = fit.mixture[j];
    }
    result[3 * MAXIMUM] = fit.likelihood;
    result[3 * MAXIMUM + 1] = fit.components;
    result[3 * MAXIMUM + 2] = fit.steps;
  }
}
