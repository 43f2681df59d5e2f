// In place of d3-delaunay, which Debian lacks: Vega's transform "voronoi" needs it, and no chart here does.
export class Delaunay {}
