// In place of d3-geo-projection, which Debian lacks: Vega's maps need it, and no chart here is one.
export function geoMollweide() {}
