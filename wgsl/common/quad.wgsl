// A quarter of a quad (a triangle's last corner stands twice): 0 to 3.

fn quarter(corners: array<vec3f, 4>, index: u32) -> array<vec3f, 4> {
    var c = corners;
    let i = index;
    let centre = 0.25 * (c[0] + c[1] + c[2] + c[3]);
    let corner = c[i];
    return array(corner, 0.5 * (corner + c[(i + 1) % 4]), centre, 0.5 * (c[(i + 3) % 4] + corner));
}
