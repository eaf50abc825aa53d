#define GL_GLEXT_PROTOTYPES
#include "world/gpu/canvas.hpp"

#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <GL/gl.h>
#include <GL/glext.h>

#include <array>
#include <string_view>

#include "plumb/world/gpu_filter.hpp"

namespace plumb::world {
namespace {

constexpr int side = 1 << Canvas::side_bits;

// A rectangle of whole pixels, each of which has its center half a pixel within.  Shaders multiply whole numbers by powers
// of two, which is exact; of quotients their language promises less.
static_assert(Canvas::side_bits == 10 && CellView::depth_bits == 16, "the powers of two below are of these");
constexpr const char* vertex_text = R"(#version 420 core
layout(location = 0) in ivec4 pixels;
layout(location = 1) in ivec2 depths_of;
layout(location = 2) in int tile_of;
flat out ivec2 depths;
uniform int pixel_bits;
uniform int side_bits;
uniform bool is_tile;
uniform int tile_asked;
void main() {
  int size = 1 << pixel_bits;
  int tile = is_tile ? tile_asked : tile_of;
  ivec4 box = is_tile ? ivec4(0, 0, size - 1, size - 1) : pixels;
  int across = side_bits - pixel_bits;
  ivec2 corner = ivec2(tile & ((1 << across) - 1), tile >> across) * size;
  corner += ivec2((gl_VertexID & 1) != 0 ? box.z + 1 : box.x, (gl_VertexID & 2) != 0 ? box.w + 1 : box.y);
  depths = depths_of;
  int half_side = 1 << (side_bits - 1);
  gl_Position = vec4(vec2(corner - half_side) * 0.001953125, 0.0, 1.0);  // 2^-9
}
)";

constexpr std::array<const char*, 6> fragment_texts{
    // The nearest depth, or, to be asked, the farthest one.
    R"(#version 420 core
flat in ivec2 depths;
uniform bool is_asked;
uniform bool from_behind;
void main() {
  ivec2 d = from_behind ? ivec2(65535) - depths.yx : depths;
  gl_FragDepth = float(is_asked ? d.y : d.x) * 0.0000152587890625;  // 2^-16
}
)",
    // The least is kept of each number, so that of the greatest depth it is that of its negative.
    R"(#version 420 core
flat in ivec2 depths;
out vec4 least;
void main() { least = vec2(depths.x, -depths.y).xyxy; }
)",
    R"(#version 420 core
flat in ivec2 depths;
out uvec4 mask;
uint below(int bits) { return bits <= 0 ? 0u : bits >= 32 ? 0xffffffffu : (1u << uint(bits)) - 1u; }
void main() {
  ivec2 slice = depths >> 9;
  for (int i = 0; i < 4; ++i) mask[i] = below(slice.y + 1 - 32 * i) & ~below(slice.x - 32 * i);
}
)",
    R"(#version 420 core
uniform sampler2D spans;
void main() {
  vec4 s = texelFetch(spans, ivec2(gl_FragCoord.xy), 0);
  if (s.x + s.w > 0.0 || s.z + s.y > 0.0) discard;
}
)",
    R"(#version 420 core
flat in ivec2 depths;
uniform sampler2D spans;
void main() {
  vec4 s = texelFetch(spans, ivec2(gl_FragCoord.xy), 0);
  if (s.x > float(depths.y) || float(depths.x) > -s.y) discard;
}
)",
    R"(#version 420 core
flat in ivec2 depths;
uniform usampler2D slices;
uint below(int bits) { return bits <= 0 ? 0u : bits >= 32 ? 0xffffffffu : (1u << uint(bits)) - 1u; }
void main() {
  uvec4 there = texelFetch(slices, ivec2(gl_FragCoord.xy), 0);
  ivec2 slice = depths >> 9;
  uint shared_slices = 0u;
  for (int i = 0; i < 4; ++i) shared_slices |= there[i] & below(slice.y + 1 - 32 * i) & ~below(slice.x - 32 * i);
  if (shared_slices == 0u) discard;
}
)"};

std::uint32_t compiled(GLenum kind, const char* text) {
  const GLuint shader = glCreateShader(kind);
  glShaderSource(shader, 1, &text, nullptr);
  glCompileShader(shader);
  GLint is_right = 0;
  glGetShaderiv(shader, GL_COMPILE_STATUS, &is_right);
  if (is_right == 0) {
    std::array<char, 512> log{};
    glGetShaderInfoLog(shader, log.size(), nullptr, log.data());
    throw Error(std::string("GpuFilter: the driver does not compile a shader: ") + log.data());
  }
  return shader;
}

std::uint32_t texture(GLint kind, GLenum format, GLenum type) {
  GLuint name = 0;
  glGenTextures(1, &name);
  glBindTexture(GL_TEXTURE_2D, name);
  glTexImage2D(GL_TEXTURE_2D, 0, kind, side, side, 0, format, type, nullptr);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  return name;
}

std::uint32_t target(std::uint32_t color, std::uint32_t depth) {
  GLuint name = 0;
  glGenFramebuffers(1, &name);
  glBindFramebuffer(GL_FRAMEBUFFER, name);
  if (color != 0) glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, color, 0);
  if (depth != 0) glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, depth, 0);
  glDrawBuffer(color != 0 ? GL_COLOR_ATTACHMENT0 : GL_NONE);
  if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
    throw Error("GpuFilter: the driver does not draw on what a filter draws on");
  return name;
}

struct Device {
  EGLDisplay display = EGL_NO_DISPLAY;
  EGLContext context = EGL_NO_CONTEXT;
};

Device opened(EGLDisplay display) {
  if (display == EGL_NO_DISPLAY || eglInitialize(display, nullptr, nullptr) == EGL_FALSE) return {};
  if (eglBindAPI(EGL_OPENGL_API) == EGL_FALSE) return {};
  constexpr std::array<EGLint, 5> wanted{EGL_SURFACE_TYPE, 0, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_NONE};
  constexpr std::array<EGLint, 7> core{
      EGL_CONTEXT_MAJOR_VERSION,           4,       EGL_CONTEXT_MINOR_VERSION, 2, EGL_CONTEXT_OPENGL_PROFILE_MASK,
      EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT, EGL_NONE};
  EGLConfig config = nullptr;
  EGLint found = 0;
  if (eglChooseConfig(display, wanted.data(), &config, 1, &found) == EGL_FALSE || found == 0) return {};
  const EGLContext context = eglCreateContext(display, config, EGL_NO_CONTEXT, core.data());
  if (context == EGL_NO_CONTEXT) return {};
  if (eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context) == EGL_FALSE) {
    eglDestroyContext(display, context);
    return {};
  }
  return {display, context};
}

/// The first that draws: devices as EGL lists them, then Mesa without a surface, then what a display's server has.
Device first_device() {
  const auto platform =
      reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(eglGetProcAddress("eglGetPlatformDisplayEXT"));
  const auto devices = reinterpret_cast<PFNEGLQUERYDEVICESEXTPROC>(eglGetProcAddress("eglQueryDevicesEXT"));
  if (platform != nullptr && devices != nullptr) {
    std::array<EGLDeviceEXT, 16> found{};
    EGLint count = 0;
    if (devices(static_cast<EGLint>(found.size()), found.data(), &count) == EGL_FALSE) count = 0;
    for (EGLint i = 0; i < count; ++i) {
      const Device device = opened(platform(EGL_PLATFORM_DEVICE_EXT, found[static_cast<std::size_t>(i)], nullptr));
      if (device.context != EGL_NO_CONTEXT) return device;
    }
  }
  if (platform != nullptr) {
    const Device device =
        opened(platform(EGL_PLATFORM_SURFACELESS_MESA, reinterpret_cast<void*>(EGL_DEFAULT_DISPLAY), nullptr));
    if (device.context != EGL_NO_CONTEXT) return device;
  }
  return opened(eglGetDisplay(EGL_DEFAULT_DISPLAY));
}

}  // namespace

Canvas::Use::Use(const Canvas& canvas)
    : display_(eglGetCurrentDisplay()),
      draw_(eglGetCurrentSurface(EGL_DRAW)),
      read_(eglGetCurrentSurface(EGL_READ)),
      context_(eglGetCurrentContext()),
      api_(eglQueryAPI()) {
  eglBindAPI(EGL_OPENGL_API);
  if (canvas.display_ != nullptr &&
      eglMakeCurrent(canvas.display_, EGL_NO_SURFACE, EGL_NO_SURFACE, canvas.context_) == EGL_FALSE) {
    eglBindAPI(api_);
    throw Error("GpuFilter: the context of this filter is in use on another thread");
  }
}

Canvas::Use::~Use() {
  if (const EGLDisplay own = eglGetCurrentDisplay(); own != EGL_NO_DISPLAY)
    eglMakeCurrent(own, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  eglBindAPI(api_);
  if (context_ != EGL_NO_CONTEXT) eglMakeCurrent(display_, draw_, read_, context_);
}

Canvas::Canvas(int pixel_bits) : pixel_bits_(pixel_bits) {
  const Use use(*this);
  const Device device = first_device();
  if (device.context == EGL_NO_CONTEXT) {
    throw NoGpu(
        "GpuFilter: no EGL device draws by OpenGL 4.2 without a display; devices, Mesa without a surface and "
        "the default display were tried (Debian: apt-get install libegl1 libgl1-mesa-dri)");
  }
  display_ = device.display;
  context_ = device.context;
  try {
    renderer_ = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
    make_programs();
    make_targets();
    check("GpuFilter");
  } catch (...) {
    eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    eglDestroyContext(display_, context_);
    throw;
  }
}

Canvas::~Canvas() { eglDestroyContext(display_, context_); }  // with all that is in it

void Canvas::check(const char* what) {
  if (const GLenum error = glGetError(); error != GL_NO_ERROR)
    throw Error(std::string(what) + ": OpenGL has failed with error " + std::to_string(error));
}

void Canvas::make_programs() {
  const GLuint vertex = compiled(GL_VERTEX_SHADER, vertex_text);
  for (std::size_t i = 0; i < fragment_texts.size(); ++i) {
    const GLuint program = glCreateProgram(), fragment = compiled(GL_FRAGMENT_SHADER, fragment_texts[i]);
    glAttachShader(program, vertex);
    glAttachShader(program, fragment);
    glLinkProgram(program);
    GLint is_right = 0;
    glGetProgramiv(program, GL_LINK_STATUS, &is_right);
    if (is_right == 0) throw Error("GpuFilter: the driver does not link a program of shaders");
    glUseProgram(program);
    glUniform1i(glGetUniformLocation(program, "pixel_bits"), pixel_bits_);
    glUniform1i(glGetUniformLocation(program, "side_bits"), side_bits);
    programs_[i] = program;
  }
}

void Canvas::make_targets() {
  depths_ = texture(GL_DEPTH_COMPONENT32F, GL_DEPTH_COMPONENT, GL_FLOAT);
  spans_ = texture(GL_RGBA32F, GL_RGBA, GL_FLOAT);
  slices_ = texture(GL_RGBA32UI, GL_RGBA_INTEGER, GL_UNSIGNED_INT);
  blank_ = texture(GL_R8, GL_RED, GL_UNSIGNED_BYTE);
  depth_target_ = target(0, depths_);
  span_target_ = target(spans_, 0);
  slice_target_ = target(slices_, 0);
  query_target_ = target(blank_, 0);
  glGenVertexArrays(1, &vertices_);
  glBindVertexArray(vertices_);
  glGenBuffers(1, &buffer_);
  glBindBuffer(GL_ARRAY_BUFFER, buffer_);
  constexpr std::array<GLint, 3> sizes{4, 2, 1};
  for (std::size_t i = 0, offset = 0; i < sizes.size(); offset += sizeof(GLint) * std::size_t(sizes[i]), ++i) {
    const auto at = static_cast<GLuint>(i);
    glEnableVertexAttribArray(at);
    glVertexAttribIPointer(at, sizes[i], GL_INT, sizeof(CellRange), reinterpret_cast<const void*>(offset));
    glVertexAttribDivisor(at, 1);
  }
  glViewport(0, 0, side, side);
  glBlendEquation(GL_MIN);
  glBlendFunc(GL_ONE, GL_ONE);
  glLogicOp(GL_OR);
}

void Canvas::upload(const std::vector<CellRange>& ranges) {
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(ranges.size() * sizeof(CellRange)), ranges.data(),
               GL_STREAM_DRAW);
}

void Canvas::use(Program program) { glUseProgram(programs_[static_cast<std::size_t>(program)]); }

/// The program must be in use.
void Canvas::set(Program program, const char* uniform, std::int32_t value) {
  glUniform1i(glGetUniformLocation(programs_[static_cast<std::size_t>(program)], uniform), value);
}

void Canvas::draw(const RangeSpan& ranges) {
  if (ranges.count == 0) return;
  glDrawArraysInstancedBaseInstance(GL_TRIANGLE_STRIP, 0, 4, static_cast<GLsizei>(ranges.count),
                                    static_cast<GLuint>(ranges.first));
}

void Canvas::begin_query(std::size_t query) {
  if (query >= queries_.size()) {
    const std::size_t before = queries_.size();
    queries_.resize(2 * query + 64);
    glGenQueries(static_cast<GLsizei>(queries_.size() - before), queries_.data() + before);
  }
  glBeginQuery(GL_ANY_SAMPLES_PASSED, queries_[query]);
}
void Canvas::end_query() { glEndQuery(GL_ANY_SAMPLES_PASSED); }

void Canvas::clear_depths() {
  glBindFramebuffer(GL_FRAMEBUFFER, depth_target_);
  glEnable(GL_DEPTH_TEST);
  glDepthMask(GL_TRUE);
  glClearDepth(1);
  glClear(GL_DEPTH_BUFFER_BIT);
  use(Program::depth);
}
void Canvas::ask_depths(const RangeSpan& ranges, std::size_t query, bool from_behind) {
  set(Program::depth, "is_asked", 1);
  set(Program::depth, "from_behind", from_behind ? 1 : 0);
  glDepthFunc(GL_GEQUAL);
  glDepthMask(GL_FALSE);
  begin_query(query);
  draw(ranges);
  end_query();
}
void Canvas::draw_depths(const RangeSpan& ranges, bool from_behind) {
  set(Program::depth, "is_asked", 0);
  set(Program::depth, "from_behind", from_behind ? 1 : 0);
  glDepthFunc(GL_LESS);
  glDepthMask(GL_TRUE);
  draw(ranges);
}

void Canvas::clear_spans() {
  glBindFramebuffer(GL_FRAMEBUFFER, span_target_);
  glDisable(GL_DEPTH_TEST);
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  constexpr std::array<GLfloat, 4> nothing{65536, 65536, 65536, 65536};  // farther than all, and nearer
  glClearBufferfv(GL_COLOR, 0, nothing.data());
}
void Canvas::draw_spans(const RangeSpan& ranges, Side of) {
  const GLboolean a = of == Side::a ? GL_TRUE : GL_FALSE, b = of == Side::b ? GL_TRUE : GL_FALSE;
  glBindFramebuffer(GL_FRAMEBUFFER, span_target_);
  glColorMask(a, a, b, b);
  glEnable(GL_BLEND);
  use(Program::span);
  draw(ranges);
  glDisable(GL_BLEND);
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
}

void Canvas::clear_slices() {
  glBindFramebuffer(GL_FRAMEBUFFER, slice_target_);
  glDisable(GL_DEPTH_TEST);
  constexpr std::array<GLuint, 4> nothing{};
  glClearBufferuiv(GL_COLOR, 0, nothing.data());
}
void Canvas::draw_slices(const RangeSpan& ranges) {
  glBindFramebuffer(GL_FRAMEBUFFER, slice_target_);
  glEnable(GL_COLOR_LOGIC_OP);
  use(Program::slices);
  draw(ranges);
  glDisable(GL_COLOR_LOGIC_OP);
}

void Canvas::ask(Program program, std::uint32_t of, const RangeSpan& ranges, std::size_t query) {
  glBindFramebuffer(GL_FRAMEBUFFER, query_target_);
  glBindTexture(GL_TEXTURE_2D, of);
  use(program);
  begin_query(query);
  draw(ranges);
  end_query();
}
void Canvas::ask_spans(std::int32_t tile, std::size_t query) {
  use(Program::compare);
  set(Program::compare, "is_tile", 1);
  set(Program::compare, "tile_asked", tile);
  ask(Program::compare, spans_, {0, 1}, query);
}
void Canvas::ask_ranges_in_spans(const RangeSpan& ranges, std::size_t query) {
  ask(Program::in_spans, spans_, ranges, query);
}
void Canvas::ask_ranges_in_slices(const RangeSpan& ranges, std::size_t query) {
  ask(Program::in_slices, slices_, ranges, query);
}

std::vector<bool> Canvas::read(std::size_t count) {
  std::vector<bool> answers(count);
  for (std::size_t i = 0; i < count; ++i) {
    GLuint any = 1;
    glGetQueryObjectuiv(queries_[i], GL_QUERY_RESULT, &any);
    answers[i] = any != 0;
  }
  check("GpuFilter");
  return answers;
}

}  // namespace plumb::world
