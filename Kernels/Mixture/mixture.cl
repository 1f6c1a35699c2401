// Greedy expectation maximisation of a 1-D Gaussian mixture in one launch of one work-group of any size; the order of
// steps is that of mixture.cxx. All phases of all steps share one reduction inside one loop: every work-item keeps the
// small state for itself, all alike, so the only barriers are the reduction's.
// REAL is double where the device has it, else float; V holds WIDTH of them: 1 where
// work-items are the vector lanes, 8 where there is one work-item.
// MAXIMUM is the largest number of components, TINY the smallest normal number.
#ifdef USE_DOUBLE
#pragma OPENCL EXTENSION cl_khr_fp64 : enable
#endif

#define JOIN_(a, b) a##b
#define JOIN(a, b) JOIN_(a, b)
#if WIDTH == 1
#define V REAL
#define LOAD(i, p) (p)[i]
#define STORE(v, i, p) (p)[i] = (v)
#define TOTAL(v) (v)
#else
#define V JOIN(REAL, 8)
#define LOAD(i, p) vload8(i, p)
#define STORE(v, i, p) vstore8(v, i, p)
#define TOTAL(v) \
  ((((v).s0 + (v).s1) + ((v).s2 + (v).s3)) + (((v).s4 + (v).s5) + ((v).s6 + (v).s7)))
#endif

#define WEIGHT(k) (3 * (k))
#define MEAN(k) (3 * (k) + 1)
#define VARIANCE(k) (3 * (k) + 2)
#define LOG_TWO_PI ((REAL)1.8378770664093453)

enum
{
  MASS,   // of component k: sums of r and r x
  SPREAD, // of component k: sum of r (x - mean)^2
  SCORE,  // of candidate c
  DONE
};

// vectors of V hold n samples, the last one padded; inside is 1 for a sample, 0 for padding. result: weight, mean,
// variance per component, then the log-likelihood. counts: components, EM steps.
kernel void greedyMixture(const int n, const int vectors, global const REAL* samples, global const REAL* inside,
  const int candidates, global const REAL* means, const REAL width, const int maximumComponents, const REAL floor_,
  const int maximumSteps, const REAL gain, global REAL* density, global REAL* shares, local REAL* work,
  global REAL* result, global int* counts)
{
  const int item = (int)get_local_id(0);
  const int size = (int)get_local_size(0);
  REAL fitted[3 * MAXIMUM], trial[3 * MAXIMUM], next[3 * MAXIMUM], converged[3 * MAXIMUM];
  REAL mass[MAXIMUM], first[MAXIMUM];
  REAL likelihood = -INFINITY, reached = -INFINITY, ownLikelihood = 0, now = 0, kMass = 0;
  REAL bestWeight = (REAL)0.5, bestMean = 0, best = -INFINITY;
  int components = 1, steps = 0, insertionSteps = 0, k = 0, c = 0, phase = MASS;
  trial[WEIGHT(0)] = 1;
  trial[MEAN(0)] = samples[0];
  trial[VARIANCE(0)] = 1;

  while (phase != DONE)
  {
    REAL a = 0, b = 0, d = 0;
    if (phase == MASS)
    {
      if (k == 0)
      {
        REAL constants[MAXIMUM], inverse[MAXIMUM];
        V masses[MAXIMUM], firsts[MAXIMUM];
        V logs = (V)(0);
        for (int j = 0; j < components; ++j)
        {
          constants[j] = log(trial[WEIGHT(j)]) - (REAL)0.5 * (LOG_TWO_PI + log(trial[VARIANCE(j)]));
          inverse[j] = (REAL)0.5 / trial[VARIANCE(j)];
          masses[j] = firsts[j] = (V)(0);
        }
        for (int i = item; i < vectors; i += size)
        {
          const V x = LOAD(i, samples);
          const V one = LOAD(i, inside);
          V terms[MAXIMUM];
          V largest = (V)(-INFINITY);
          for (int j = 0; j < components; ++j)
          {
            const V off = x - trial[MEAN(j)];
            terms[j] = constants[j] - off * off * inverse[j];
            largest = fmax(largest, terms[j]);
          }
          V sum = (V)(0);
          for (int j = 0; j < components; ++j)
          {
            terms[j] = exp(terms[j] - largest);
            sum += terms[j];
          }
          logs += one * (largest + log(sum));
          for (int j = 0; j < components; ++j)
          {
            const V share = one * terms[j] / sum;
            STORE(share, j * vectors + i, shares);
            masses[j] += share;
            firsts[j] += share * x;
          }
        }
        for (int j = 0; j < components; ++j)
        {
          mass[j] = TOTAL(masses[j]);
          first[j] = TOTAL(firsts[j]);
        }
        ownLikelihood = TOTAL(logs);
      }
      a = mass[k];
      b = first[k];
      d = ownLikelihood;
    }
    else if (phase == SPREAD)
    {
      V sum = (V)(0);
      for (int i = item; i < vectors; i += size)
      {
        const V off = LOAD(i, samples) - next[MEAN(k)];
        sum += LOAD(k * vectors + i, shares) * off * off;
      }
      a = TOTAL(sum);
    }
    else
    {
      if (c == 0)
      {
        for (int i = item; i < vectors; i += size)
        {
          V sum = (V)(0);
          for (int j = 0; j < components; ++j)
          {
            const V off = LOAD(i, samples) - fitted[MEAN(j)];
            sum += fitted[WEIGHT(j)] * rsqrt((REAL)6.283185307179586 * fitted[VARIANCE(j)]) *
              exp(-(REAL)0.5 * off * off / fitted[VARIANCE(j)]);
          }
          STORE(sum, i, density);
        }
      }
      const REAL scale = rsqrt((REAL)6.283185307179586 * width);
      V even = (V)(0), sum = (V)(0), squares = (V)(0);
      for (int i = item; i < vectors; i += size)
      {
        const V one = LOAD(i, inside);
        const V f = LOAD(i, density);
        const V off = LOAD(i, samples) - means[c];
        const V phi = scale * exp(-(REAL)0.5 * off * off / width);
        const V total = fmax(f + phi, (V)(TINY)); // both may underflow
        const V delta = one * (f - phi) / total;
        even += one * log((REAL)0.5 * total);
        sum += delta;
        squares += delta * delta;
      }
      a = TOTAL(even);
      b = TOTAL(sum);
      d = TOTAL(squares);
    }

    // Sums a, b, d over the work-group; every work-item gets the result.
    work[item] = a;
    work[size + item] = b;
    work[2 * size + item] = d;
    barrier(CLK_LOCAL_MEM_FENCE);
    for (int count = size; count > 1; count = (count + 1) / 2)
    {
      const int upper = (count + 1) / 2;
      if (item < count / 2)
      {
        work[item] += work[item + upper];
        work[size + item] += work[size + item + upper];
        work[2 * size + item] += work[2 * size + item + upper];
      }
      barrier(CLK_LOCAL_MEM_FENCE);
    }
    a = work[0];
    b = work[size];
    d = work[2 * size];
    barrier(CLK_LOCAL_MEM_FENCE);

    if (phase == MASS)
    {
      now = d;
      kMass = a;
      next[WEIGHT(k)] = fmax(a / n, (REAL)1e-12);
      next[MEAN(k)] = a > 0 ? b / a : trial[MEAN(k)];
      phase = SPREAD;
    }
    else if (phase == SPREAD)
    {
      next[VARIANCE(k)] = fmax(kMass > 0 ? a / kMass : (REAL)0, floor_);
      phase = MASS;
      if (++k == components) // an EM step is complete
      {
        k = 0;
        ++steps;
        ++insertionSteps;
        const bool rises = now > reached + gain;
        if (components == 1)
        {
          // The first step lands on the samples' own mean and variance, the second tells its likelihood.
          if (steps == 2)
          {
            likelihood = now;
            --steps;
            phase = maximumComponents > 1 ? SCORE : DONE;
          }
          for (int j = 0; j < 3; ++j)
          {
            fitted[j] = steps == 1 && phase != MASS ? trial[j] : next[j];
            trial[j] = next[j];
          }
        }
        else
        {
          if (now > reached)
          {
            reached = now;
            for (int j = 0; j < 3 * components; ++j)
            {
              converged[j] = trial[j];
            }
          }
          for (int j = 0; j < 3 * components; ++j)
          {
            trial[j] = next[j];
          }
          if (!rises || insertionSteps == maximumSteps)
          {
            if (reached > likelihood + gain)
            {
              likelihood = reached;
              for (int j = 0; j < 3 * components; ++j)
              {
                fitted[j] = converged[j];
              }
              phase = components < maximumComponents ? SCORE : DONE;
            }
            else
            {
              --components;
              phase = DONE;
            }
          }
        }
      }
    }
    else
    {
      if (d > 0)
      {
        const REAL weight = clamp((REAL)0.5 - (REAL)0.5 * b / d, (REAL)0.01, (REAL)0.99);
        const REAL away = weight - (REAL)0.5;
        const REAL score = a - 2 * away * b - 2 * away * away * d;
        if (score > best)
        {
          best = score;
          bestWeight = weight;
          bestMean = means[c];
        }
      }
      if (++c == candidates) // insert the best
      {
        for (int j = 0; j < components; ++j)
        {
          trial[WEIGHT(j)] = (1 - bestWeight) * fitted[WEIGHT(j)];
          trial[MEAN(j)] = fitted[MEAN(j)];
          trial[VARIANCE(j)] = fitted[VARIANCE(j)];
        }
        trial[WEIGHT(components)] = bestWeight;
        trial[MEAN(components)] = bestMean;
        trial[VARIANCE(components)] = width;
        ++components;
        c = 0;
        best = -INFINITY;
        reached = -INFINITY;
        insertionSteps = 0;
        phase = MASS;
      }
    }
  }
  if (item == 0)
  {
    for (int j = 0; j < 3 * components; ++j)
    {
      result[j] = fitted[j];
    }
    result[3 * MAXIMUM] = likelihood;
    counts[0] = components;
    counts[1] = steps;
  }
}
