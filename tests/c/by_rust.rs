// The C interface from Rust, by declarations that were written by hand as a user would: figures, errors, a mesh whose
// arrays are seen where they lie, and a callback.
use std::ffi::{c_void, CStr, CString};
use std::os::raw::{c_char, c_int};
use std::ptr;

#[repr(C)]
struct Figure {
    size: usize,
    kind: i32,
    dimension: i32,
    numbers: [f64; 15], // the union's longest member: an obb3
    pose_kind: i32,
    pose: [f64; 12],
    kept: *const c_void,
}

#[repr(C)]
struct Closest {
    size: usize,
    on_a: [f64; 3],
    on_b: [f64; 3],
    distance: f64,
    feature_a: [u32; 2],
    feature_b: [u32; 2],
}

#[repr(C)]
struct Loop {
    vertices: *const u32,
    count: usize,
    is_closed: i32,
}

enum Mesh {}
enum Loops {}
enum Points {}

#[link(name = "plumb_c")]
extern "C" {
    fn plumb_last_error() -> *const c_char;
    fn plumb_find_sign(name: *const c_char) -> usize;
    fn plumb_sign(which: usize, numbers: *const f64, sign: *mut c_int) -> c_int;
    fn plumb_relate(a: *const Figure, b: *const Figure, relation: *mut c_int) -> c_int;
    fn plumb_closest_points(a: *const Figure, b: *const Figure, closest: *mut Closest) -> c_int;
    fn plumb_mesh_create(vertices: *const f64, vertex_count: usize, triangles: *const u32, triangle_count: usize,
                         mesh: *mut *mut Mesh) -> c_int;
    fn plumb_mesh_vertices(mesh: *const Mesh, vertices: *mut *const f64, count: *mut usize) -> c_int;
    fn plumb_mesh_destroy(mesh: *mut Mesh);
    fn plumb_mesh_boundary_loops(mesh: *const Mesh, loops: *mut *mut Loops) -> c_int;
    fn plumb_loops_of(loops: *const Loops, each: *mut *const Loop, count: *mut usize) -> c_int;
    fn plumb_loops_destroy(loops: *mut Loops);
    fn plumb_points_create(points: *const f64, count: usize, dimension: c_int, tree: *mut *mut Points) -> c_int;
    fn plumb_points_within(tree: *const Points, query: *const f64, radius: f64,
                           take: extern "C" fn(u32, *mut c_void) -> c_int, user: *mut c_void) -> c_int;
    fn plumb_points_destroy(tree: *mut Points);
}

fn last_error() -> String {
    unsafe { CStr::from_ptr(plumb_last_error()) }.to_string_lossy().into_owned()
}

fn figure(kind: i32, numbers: &[f64]) -> Figure {
    let mut made = Figure {
        size: std::mem::size_of::<Figure>(),
        kind,
        dimension: 3,
        numbers: [0.0; 15],
        pose_kind: 0,
        pose: [0.0; 12],
        kept: ptr::null(),
    };
    made.numbers[..numbers.len()].copy_from_slice(numbers);
    made
}

const BALL: i32 = 14;
const AABB: i32 = 15;

extern "C" fn take(index: u32, user: *mut c_void) -> c_int {
    unsafe { (*(user as *mut Vec<u32>)).push(index) };
    1
}

fn main() {
    unsafe {
        let ball = figure(BALL, &[0.0, 0.0, 0.0, 1.0]);
        let touching = figure(AABB, &[1.0, -1.0, -1.0, 2.0, 1.0, 1.0]);
        let mut relation = 7;
        assert_eq!(plumb_relate(&ball, &touching, &mut relation), 0, "{}", last_error());
        assert_eq!(relation, 0);
        assert_eq!(plumb_relate(&ball, &figure(BALL, &[0.0, 0.0, 0.0, -1.0]), &mut relation), 3);
        assert!(last_error().contains("radius"), "{}", last_error());

        let mut closest: Closest = std::mem::zeroed();
        let far = figure(BALL, &[0.0, 5.0, 0.0, 1.0]);
        assert_eq!(plumb_closest_points(&ball, &far, &mut closest), 1, "a size that nobody set");
        closest.size = std::mem::size_of::<Closest>();
        assert_eq!(plumb_closest_points(&ball, &far, &mut closest), 0, "{}", last_error());
        assert_eq!((closest.distance, closest.on_a, closest.on_b), (3.0, [0.0, 1.0, 0.0], [0.0, 4.0, 0.0]));

        let name = CString::new("orient2d").unwrap();
        let mut sign = 7;
        assert_eq!(plumb_sign(plumb_find_sign(name.as_ptr()), [0.0, 0.0, 0.1, 0.3, 0.3, 0.9].as_ptr(), &mut sign), 0);
        assert_eq!(sign, 1);

        let vertices = [0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0];
        let (mut mesh, mut loops) = (ptr::null_mut(), ptr::null_mut());
        assert_eq!(plumb_mesh_create(vertices.as_ptr(), 3, [0u32, 1, 2].as_ptr(), 1, &mut mesh), 0, "{}", last_error());
        let (mut there, mut count) = (ptr::null(), 0);
        assert_eq!(plumb_mesh_vertices(mesh, &mut there, &mut count), 0);
        assert_eq!(std::slice::from_raw_parts(there, 3 * count), vertices);
        assert_eq!(plumb_mesh_boundary_loops(mesh, &mut loops), 0, "{}", last_error());
        let mut each = ptr::null();
        assert_eq!(plumb_loops_of(loops, &mut each, &mut count), 0);
        let all = std::slice::from_raw_parts(each, count);
        assert_eq!((all.len(), all[0].count, all[0].is_closed), (1, 3, 1));
        assert!(std::slice::from_raw_parts(all[0].vertices, 3).iter().all(|v| *v < 3));
        plumb_loops_destroy(loops);
        plumb_mesh_destroy(mesh);

        let points = [0.0, 0.0, 3.0, 4.0, 1.0, 0.0];
        let mut tree = ptr::null_mut();
        assert_eq!(plumb_points_create(points.as_ptr(), 3, 2, &mut tree), 0, "{}", last_error());
        let mut taken: Vec<u32> = Vec::new();
        let user = &mut taken as *mut Vec<u32> as *mut c_void;
        assert_eq!(plumb_points_within(tree, points.as_ptr(), 5.0, take, user), 0, "{}", last_error());
        plumb_points_destroy(tree);
        assert_eq!(taken, [0, 1, 2]);
    }
    println!("all as it should be");
}
