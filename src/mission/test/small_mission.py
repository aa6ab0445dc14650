"""A small mission for tests: two agents, three daily windows, 60 x 50 cells, an
eddy beside a coast, generated from closed formulas. The file is packed as
HYCOM's are.
"""

import os

import netCDF4
import numpy as np

WINDOWS = 3
DAYS = WINDOWS + 2        # One before the first window, one after the last.
BEGIN = '2026-06-02T00:00:00Z'
COLS, ROWS, SPACING_DEG = 60, 50, 0.04
WEST_DEG, SOUTH_DEG = -92.0, 25.0
LAND_COLS = 6
FILL = -30000

MISSION = """\
@prefix ex: <http://example.org/mission/> .
@prefix geo: <http://www.opengis.net/ont/geosparql#> .
@prefix time: <http://www.w3.org/2006/time#> .
@prefix xsd: <http://www.w3.org/2001/XMLSchema#> .

ex:mission a ex:Mission ; ex:name "small" ;
    ex:hasWindow %(window_list)s ; ex:hasAgent ex:alpha , ex:bravo ;
    ex:teamMode "greedy" ; ex:minimumSeparationKm 4.0 ;
    ex:separationIsHard true ; ex:candidatesPerAgent 5 ;
    ex:waypointsPerWindow 8 ; ex:waypointSpacingKm 12.0 ;
    ex:maxCoolingRounds 8 .
%(windows)s
ex:currents a ex:DataSource ; ex:file "ocean.nc" ; ex:provides "current" .
ex:sst a ex:DataSource ; ex:file "ocean.nc" ; ex:provides "temperature" ;
    ex:kind "delta_sst" .

ex:land a ex:Constraint ; ex:kind "no_go" ; ex:gridRef "land" ;
    ex:bufferCells 2 .
ex:sanctuary a ex:Constraint ; ex:kind "soft" ; ex:name "sanctuary" ;
    ex:attenuation 0.4 ;
    geo:asWKT "POLYGON((-91.0 25.9, -90.6 25.9, -90.6 26.3, -91.0 26.3, -91.0 25.9))"^^geo:wktLiteral .
ex:front a ex:Event ; ex:name "front" ; ex:forWindow ex:w1 ; ex:value 2.0 ;
    ex:capacity 1 ; ex:radiusKm 6.0 ;
    geo:asWKT "POINT(-90.75 25.75)"^^geo:wktLiteral .

ex:fast a ex:Policy ; ex:name "fast" ; ex:alpha_base 1.0 ; ex:beta_poi 0.5 ;
    ex:lambda_time 0.01 ; ex:lambda_energy 0.001 ; ex:lambda_risk 0.05 ;
    ex:lambda_unc 0.1 .
ex:safe a ex:Policy ; ex:name "safe" ; ex:alpha_base 1.0 ; ex:beta_poi 0.1 ;
    ex:lambda_time 0.002 ; ex:lambda_energy 0.004 ; ex:lambda_risk 0.5 ;
    ex:lambda_unc 0.2 ; ex:softOverrides '{"sanctuary": 0.1}' .

ex:alpha a ex:Agent ; ex:id "alpha" ; ex:mobility "glider" ;
    ex:usesPolicy ex:fast ; ex:hasCapabilities ex:alpha_capabilities .
ex:bravo a ex:Agent ; ex:id "bravo" ; ex:mobility "glider" ;
    ex:usesPolicy ex:fast ; ex:hasCapabilities ex:bravo_capabilities .
ex:alpha_capabilities a ex:AgentCapabilities ; ex:cruiseSpeedKts 0.6 ;
    ex:maxSpeedKts 1.2 ; ex:energyPerKm 2.0 ; ex:hotelLoadW 1.0 ;
    ex:energyBudget 5000.0 ; ex:boostGain 1.0 ; ex:sensorRadiusKm 8.0 .
ex:bravo_capabilities a ex:AgentCapabilities ; ex:cruiseSpeedKts 0.8 ;
    ex:maxSpeedKts 1.4 ; ex:energyPerKm 3.0 ; ex:hotelLoadW 1.5 ;
    ex:energyBudget 5000.0 ; ex:boostGain 1.0 ; ex:sensorRadiusKm 6.0 .
ex:alpha_start a ex:AgentState ; ex:forAgent ex:alpha ; ex:forWindow ex:w0 ;
    geo:asWKT "POINT(-90.9 25.7)"^^geo:wktLiteral ; ex:headingDeg 90.0 .
ex:bravo_start a ex:AgentState ; ex:forAgent ex:bravo ; ex:forWindow ex:w0 ;
    geo:asWKT "POINT(-90.5 26.1)"^^geo:wktLiteral ; ex:headingDeg 0.0 .
"""

WINDOW = """\
ex:w%(i)d a ex:TimeWindow ; ex:index %(i)d ; ex:confidence %(w).4f ;
    time:hasBeginning "2026-06-%(day)02dT00:00:00Z"^^xsd:dateTime ;
    time:hasEnd "2026-06-%(next)02dT00:00:00Z"^^xsd:dateTime .
"""

PLANNERS = """\
<launch>
  <node name="planner_alpha" pkg="kg_ros" type="planner_node" output="screen" respawn="true" respawn_delay="1">
    <param name="agent" value="alpha"/>
  </node>
  <node name="planner_bravo" pkg="kg_ros" type="planner_node" output="screen" respawn="true" respawn_delay="1">
    <param name="agent" value="bravo"/>
  </node>
</launch>
"""


def write_mission(folder):
    """Writes mission.ttl, planners.launch and ocean.nc into a folder."""
    windows = ''.join(WINDOW % {'i': i, 'w': np.exp(-0.12 * i), 'day': 2 + i,
                                'next': 3 + i} for i in range(WINDOWS))
    with open(os.path.join(folder, 'mission.ttl'), 'w') as file:
        file.write(MISSION % {'windows': windows, 'window_list': ' , '.join(
            'ex:w%d' % i for i in range(WINDOWS))})
    with open(os.path.join(folder, 'planners.launch'), 'w') as file:
        file.write(PLANNERS)
    write_ocean(os.path.join(folder, 'ocean.nc'))


def write_ocean(path, days=DAYS, all_land=False, without=()):
    """Writes the ocean file or a faulty variant; `days` from 1 June, 12:00."""
    with netCDF4.Dataset(path, 'w', format='NETCDF3_CLASSIC') as file:
        _write_axes(file, days)
        time, y, x = np.meshgrid(np.arange(days), np.linspace(-1, 1, ROWS),
                                 np.linspace(-1, 1, COLS), indexing='ij')
        land = np.zeros((days, ROWS, COLS), bool)
        land[:, :, :LAND_COLS] = True
        land |= all_land
        eddy = np.exp(-3.0 * (x ** 2 + y ** 2))
        warm = 26.0 + 2.0 * np.tanh(4.0 * (x - 0.4 * np.sin(
            3.0 * y + 0.8 * time) - 0.1 * time))
        fields = {'water_u': (-y * eddy, 'eastward_sea_water_velocity', 0.0),
                  'water_v': (x * eddy, 'northward_sea_water_velocity', 0.0),
                  'water_temp': (warm, 'sea_water_temperature', 20.0)}
        for name, field in fields.items():
            if name not in without:
                _write_field(file, name, field, land)


def _write_axes(file, days):
    for name, size in (('time', days), ('lat', ROWS), ('lon', COLS)):
        file.createDimension(name, size)
    time = file.createVariable('time', 'f8', ('time',))
    time.units = 'hours since 2026-06-01 00:00:00'
    time.standard_name = 'time'
    time[:] = 12.0 + 24.0 * np.arange(days)
    lat = file.createVariable('lat', 'f8', ('lat',))
    lat.units, lat.standard_name = 'degrees_north', 'latitude'
    lat[:] = SOUTH_DEG + SPACING_DEG * np.arange(ROWS)
    lon = file.createVariable('lon', 'f8', ('lon',))
    lon.units, lon.standard_name = 'degrees_east', 'longitude'
    lon[:] = WEST_DEG + SPACING_DEG * np.arange(COLS)


def _write_field(file, name, field, land):
    values, standard_name, offset = field
    variable = file.createVariable(name, 'i2', ('time', 'lat', 'lon'),
                                   fill_value=FILL)
    variable.set_auto_maskandscale(False)
    variable.standard_name = standard_name
    variable.units = 'degC' if offset else 'm/s'
    variable.scale_factor, variable.add_offset = 0.001, offset
    variable[:] = np.where(land, FILL, np.round((values - offset) / 0.001))
