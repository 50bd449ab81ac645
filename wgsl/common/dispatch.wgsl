// Long one-dimensional work spread over two dimensions, since one dimension holds at most 65535 groups.

const ROW_GROUPS = 32768u;

fn dispatch_groups(items: u32, group_size: u32) -> vec3u {
    let groups = (items + group_size - 1) / group_size;
    return vec3u(min(groups, ROW_GROUPS), (groups + ROW_GROUPS - 1) / ROW_GROUPS, 1);
}

fn dispatch_index(id: vec3u, group_size: u32) -> u32 {
    return id.y * ROW_GROUPS * group_size + id.x;
}
