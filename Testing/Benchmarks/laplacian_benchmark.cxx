// The linear systems of the deformation: order, factor, solve, drag; the plain form and the one that adjusts
// normals. Every side gets the same matrix. The region is a disk about the highest vertex of the bunny; sizes
// are numbers of unknowns. CHOLMOD runs with its own minimum degree and with METIS's nested dissection.
#include "benchmark_frame.h"
#include "sparse_peers.h"

#include "Sparse/cholesky.h"
#include "Sparse/laplacian.h"

#include <Eigen/SparseCholesky>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <memory>

namespace oversketch_bench
{

namespace
{

// One system. Its parts are made when a job first asks for them.
struct Case
{
  std::string model;
  double share; // of the vertices in the region

  void open()
  {
    if (!this->region.empty())
    {
      return;
    }
    const Mesh& mesh = oversketch_bench::model(this->model).mesh;
    this->adjacency = buildAdjacency(mesh);
    int top = 0;
    for (int v = 0; v < mesh.vertexCount(); ++v)
    {
      top = mesh.points[v][1] > mesh.points[top][1] ? v : top;
    }
    this->region.assign(mesh.points.size(), 0);
    this->region[top] = 1;
    std::vector<int> disk(1, top);
    const std::size_t wanted = static_cast<std::size_t>(this->share * mesh.vertexCount());
    for (std::size_t i = 0; disk.size() < wanted; ++i)
    {
      const Lists& ring = this->adjacency.vertexVertices;
      for (const int* n = ring.begin(disk[i]); n != ring.end(disk[i]) && disk.size() < wanted; ++n)
      {
        if (!this->region[*n])
        {
          this->region[*n] = 1;
          disk.push_back(*n);
        }
      }
    }
    for (int h = 0; h < 50; ++h)
    {
      this->handles.push_back(Binding::vertex(disk[h]));
    }
  }
  const LaplacianShape& shape(bool adjusted)
  {
    this->open();
    if (!this->shapes[adjusted])
    {
      this->shapes[adjusted] = std::make_shared<LaplacianShape>(oversketch_bench::model(this->model).mesh,
        this->adjacency,
        movableVertices(this->adjacency, this->region, this->handles),
        true,
        adjusted,
        threads());
      this->matrices[adjusted] = this->shapes[adjusted]->normalMatrix(this->handles, 10.0);
      this->eigenMatrices[adjusted] = toEigen(this->matrices[adjusted]);
    }
    return *this->shapes[adjusted];
  }
  // What the hand asks for: another place each time.
  Vector3 next()
  {
    ++this->turn;
    return { 0.05 * std::sin(0.01 * this->turn), 0.05, 0.02 * std::cos(0.01 * this->turn) };
  }
  Eigen::MatrixXd rightSide(const Vector3& d)
  {
    Eigen::MatrixXd right = Eigen::MatrixXd::Zero(this->matrices[0].nodeCount(), 3);
    for (const Binding& handle : this->handles)
    {
      right.row(this->shape(false).number[handle.vertices[0]]) += 100.0 * d;
    }
    return right;
  }

  Adjacency adjacency;
  std::vector<char> region;
  std::vector<Binding> handles;
  std::shared_ptr<LaplacianShape> shapes[2];
  BlockMatrix matrices[2];
  Sparse eigenMatrices[2];
  std::unique_ptr<LaplacianSystem> system; // the plain form, with handles
  std::unique_ptr<Cholesky> factor;        // of its matrix alone
  std::shared_ptr<FactorMemory> memory = std::make_shared<FactorMemory>();
  std::unique_ptr<Drag> drag;
  std::vector<Vector3> moves;
  std::vector<Vector3> points;
  std::unique_ptr<Eigen::SimplicialLDLT<Sparse>> eigen;
#ifdef OVERSKETCH_CHOLMOD
  std::map<int, std::unique_ptr<Cholmod>> cholmods; // by ordering
#endif
  Eigen::MatrixXd answer;
  int turn = 0;

  // What a job of solves starts from; made once.
  void readyOurs()
  {
    this->shape(false);
    if (this->system)
    {
      return;
    }
    this->system = std::make_unique<LaplacianSystem>(this->shapes[0], this->handles, 10.0, threads());
    this->factor = std::make_unique<Cholesky>(this->shapes[0]->elimination);
    this->points = oversketch_bench::model(this->model).mesh.points;
    this->drag = std::make_unique<Drag>(Drag{ this->shapes[0]->vertices,
      this->shapes[0]->positions,
      this->system->response(std::vector<double>(this->handles.size(), 1.0), threads()) });
  }
  void readyEigen()
  {
    this->shape(false);
    if (!this->eigen)
    {
      this->eigen = std::make_unique<Eigen::SimplicialLDLT<Sparse>>(this->eigenMatrices[0]);
    }
  }
#ifdef OVERSKETCH_CHOLMOD
  void readyCholmod(int ordering)
  {
    this->shape(false);
    std::unique_ptr<Cholmod>& made = this->cholmods[ordering];
    if (!made)
    {
      made = std::make_unique<Cholmod>(this->eigenMatrices[0], ordering);
      made->analyse();
      made->factorise();
    }
  }
#endif
};

// The matrix for the peers that run in another program.
void write(Case& of, const std::string& size)
{
  const char* folder = std::getenv("OVERSKETCH_BENCHMARKS");
  if (!folder)
  {
    return;
  }
  of.shape(false);
  FILE* file = std::fopen((std::string(folder) + "/" + size + ".triplets").c_str(), "w");
  const Sparse& matrix = of.eigenMatrices[0];
  for (int column = 0; file && column < matrix.cols(); ++column)
  {
    for (Sparse::InnerIterator it(matrix, column); it; ++it)
    {
      std::fprintf(file, "%d %d %.17g\n", static_cast<int>(it.row()), column, it.value());
    }
  }
  if (!file || std::fclose(file) != 0)
  {
    std::fprintf(stderr, "Cannot write the matrix of %s unknowns to %s.\n", size.c_str(), folder);
    std::exit(1);
  }
}

void addJob(const std::string& job,
  const std::string& size,
  const std::string& who,
  int threadCount,
  const std::function<void()>& prepare,
  const std::function<void()>& run,
  const std::function<std::map<std::string, double>()>& figures = {})
{
  add({ job, size, who, threadCount, prepare, run, figures });
}

// Order of elimination and the shape of the factor, from the pattern alone.
void orderJobs(const std::shared_ptr<Case>& of, const std::string& size)
{
  const std::string job = "Laplacian order";
  const auto open = [=] { of->shape(false); };
  const auto entries = [](const std::shared_ptr<double>& count) {
    return [=] { return std::map<std::string, double>{ { "factor_entries", *count } }; };
  };
  const auto own = std::make_shared<double>(0.0);
  addJob(
    job,
    size,
    "ours",
    2,
    open,
    [=]
    {
      const Elimination made(of->matrices[0].pattern, of->shapes[0]->positions, threads());
      *own = static_cast<double>(made.storedCount(of->matrices[0].block));
    },
    entries(own));
#ifdef OVERSKETCH_CHOLMOD
  for (const int ordering : Cholmod::orderings)
  {
    const auto count = std::make_shared<double>(0.0);
    addJob(
      job,
      size,
      Cholmod::name(ordering),
      1,
      open,
      [=]
      {
        Cholmod peer(of->eigenMatrices[0], ordering);
        peer.analyse();
        *count = peer.entries();
      },
      entries(count));
  }
#endif
}

// Order of elimination and factor of one form's matrix.
void factorOurs(Case& of, bool adjusted)
{
  const auto elimination =
    std::make_shared<Elimination>(of.matrices[adjusted].pattern, of.shapes[adjusted]->positions, threads());
  // In the memory of the last factor, as the filter has it from stroke to stroke.
  if (!Cholesky(elimination, of.memory).factorise(of.matrices[adjusted], threads()))
  {
    std::fprintf(stderr, "The factorisation failed.\n");
    std::exit(1);
  }
}

void factorJobs(const std::shared_ptr<Case>& of, const std::string& size)
{
  const std::string job = "Laplacian factor";
  const auto open = [=] { of->shape(false); };
  addJob(job, size, "ours", 2, open, [=] { factorOurs(*of, false); });
  addJob(job, size, "Eigen", 1, open, [=] { Eigen::SimplicialLDLT<Sparse> eigen(of->eigenMatrices[0]); });
#ifdef OVERSKETCH_CHOLMOD
  const auto cholmod = [=](bool adjusted, int ordering)
  {
    Cholmod peer(of->eigenMatrices[adjusted], ordering);
    peer.analyse();
    peer.factorise();
  };
  for (const int ordering : Cholmod::orderings)
  {
    addJob(job, size, Cholmod::name(ordering), 2, open, [=] { cholmod(false, ordering); });
  }
#endif
  const std::string adjusted = "adjusted normals";
  const auto openBoth = [=]
  {
    of->shape(false);
    of->shape(true);
  };
  addJob(adjusted, size, "ours", 2, openBoth, [=] { factorOurs(*of, true); });
  addJob(adjusted, size, "plain form", 2, openBoth, [=] { factorOurs(*of, false); });
#ifdef OVERSKETCH_CHOLMOD
  for (const int ordering : Cholmod::orderings)
  {
    addJob(adjusted, size, Cholmod::name(ordering), 2, openBoth, [=] { cholmod(true, ordering); });
  }
#endif
}

// New values in the same pattern.
void againJobs(const std::shared_ptr<Case>& of, const std::string& size)
{
  const std::string job = "Laplacian factor again";
  addJob(
    job,
    size,
    "ours",
    2,
    [=] { of->readyOurs(); },
    [=] { of->factor->factorise(of->matrices[0], threads()); });
  addJob(
    job, size, "Eigen", 1, [=] { of->readyEigen(); }, [=] { of->eigen->factorize(of->eigenMatrices[0]); });
#ifdef OVERSKETCH_CHOLMOD
  for (const int ordering : Cholmod::orderings)
  {
    addJob(
      job,
      size,
      Cholmod::name(ordering),
      2,
      [=] { of->readyCholmod(ordering); },
      [=] { of->cholmods[ordering]->factorise(); });
  }
#endif
}

void solveJobs(const std::shared_ptr<Case>& of, const std::string& size)
{
  const std::string job = "Laplacian solve";
  addJob(
    job,
    size,
    "ours",
    2,
    [=] { of->readyOurs(); },
    [=] { of->moves = of->system->solve(std::vector<Vector3>(of->handles.size(), of->next()), threads()); });
  addJob(
    job,
    size,
    "Eigen",
    1,
    [=] { of->readyEigen(); },
    [=] { of->answer = of->eigen->solve(of->rightSide(of->next())); });
#ifdef OVERSKETCH_CHOLMOD
  for (const int ordering : Cholmod::orderings)
  {
    addJob(
      job,
      size,
      Cholmod::name(ordering),
      2,
      [=] { of->readyCholmod(ordering); },
      [=]
      {
        of->answer = of->rightSide(of->next());
        of->cholmods[ordering]->solve(of->answer);
      });
  }
#endif
}

void dragJobs(const std::shared_ptr<Case>& of, const std::string& size)
{
  const std::string job = "Laplacian drag";
  addJob(
    job,
    size,
    "ours",
    2,
    [=] { of->readyOurs(); },
    [=] { of->drag->place(of->next(), of->points.front().data(), threads()); });
  addJob(
    job,
    size,
    "Eigen",
    1,
    [=] { of->readyEigen(); },
    [=] { of->answer = of->eigen->solve(of->rightSide(of->next())); });
}

} // namespace

void jobs()
{
  const struct
  {
    const char *size, *model;
    double share;
  } wanted[] = { { "7.5k", "30k", 0.5 }, { "18k", "180k", 0.2 }, { "45k", "180k", 0.5 } };
  for (const auto& [size, model, share] : wanted)
  {
    if (sizes({ model }).empty())
    {
      continue;
    }
    auto of = std::make_shared<Case>();
    of->model = model;
    of->share = share;
    write(*of, size);
    orderJobs(of, size);
    factorJobs(of, size);
    againJobs(of, size);
    solveJobs(of, size);
    dragJobs(of, size);
  }
}

} // namespace oversketch_bench
