// Does `using namespace plumb` leave a user the names that programs are full of?  A name of ours that is one of these
// would make each use of it ambiguous.
#include <gtest/gtest.h>

#include "plumb/degenerate.hpp"
#include "plumb/plumb.hpp"

using namespace plumb;

#define OWN(name)  \
  struct name {    \
    int value = 1; \
  }
OWN(Program);
OWN(Instruction);
OWN(Tape);
OWN(Application);
OWN(Box);
OWN(Camera);
OWN(Cell);
OWN(Circle);
OWN(Color);
OWN(Config);
OWN(Edge);
OWN(Entry);
OWN(Face);
OWN(Grid);
OWN(Image);
OWN(Item);
OWN(Line);
OWN(Mesh);
OWN(Node);
OWN(Options);
OWN(Parser);
OWN(Part);
OWN(Plane);
OWN(Point);
OWN(Polygon);
OWN(Range);
OWN(Ray);
OWN(Reader);
OWN(Result);
OWN(Scene);
OWN(Search);
OWN(Segment);
OWN(Settings);
OWN(Shape);
OWN(Sphere);
OWN(State);
OWN(Timer);
OWN(Token);
OWN(Transform);
OWN(Tree);
OWN(Triangle);
OWN(Vec);
OWN(Vec2);
OWN(Vec3);
OWN(Vector);
OWN(Vertex);
OWN(World);
OWN(Writer);

int program = 1;

TEST(OwnNames, AreTheUsers) {
  const Program p;
  const Point2 a{0, 0};
  EXPECT_EQ(p.value + program + Mesh().value + Point().value + Range().value, 5);
  EXPECT_EQ(orient2d(a, a, a), Sign::zero);
  int sum = 0;
  sum += Instruction().value + Tape().value + Application().value + Box().value + Camera().value + Cell().value;
  sum += Circle().value + Color().value + Config().value + Edge().value + Entry().value + Face().value + Grid().value;
  sum += Image().value + Item().value + Line().value + Node().value + Options().value + Parser().value + Part().value;
  sum += Plane().value + Polygon().value + Ray().value + Reader().value + Result().value + Scene().value;
  sum += Search().value + Segment().value + Settings().value + Shape().value + Sphere().value + State().value;
  sum += Timer().value + Token().value + Transform().value + Tree().value + Triangle().value + Vec().value;
  sum += Vec2().value + Vec3().value + Vector().value + Vertex().value + World().value + Writer().value;
  EXPECT_EQ(sum, 44);
}
